//! Definitions that several results have: a sentence without its full stop, for readers.

pub(crate) const ABOVE_0_1: &str = "contacts that begin with an approach speed above 0.1 m/s";
pub(crate) const ABOVE_0_5: &str = "contacts that begin with an approach speed above 0.5 m/s";
pub(crate) const ABOVE_1: &str = "contacts that begin with an approach speed above 1 m/s";
pub(crate) const BETA0: &str = "theoretical critical gap, as published: a gap that just closes in a raceway in which balls roll without sliding";
pub(crate) const BETA0_SEARCHED: &str = "theoretical critical gap, as published; on elastic flanks and in space that of rolling at the contact angle and deflection of the most loaded ball, in the row and at the operating point with the least";
pub(crate) const BPFI: &str = "ball pass frequency of the inner ring";
pub(crate) const BPFO: &str = "ball pass frequency of the outer ring";
pub(crate) const BSF: &str = "ball spin frequency: rotations of a ball about its axis per second";
pub(crate) const COLLISIONS: &str = "contacts between two balls, from its start to its end";
pub(crate) const CRITERION: &str = "the criterion with the least margin, or the one that is missed by most";
pub(crate) const CRITICAL_GAP: &str = "largest gap at the entrance of the raceway that closes inside, from the motion of two balls";
pub(crate) const DOUBLE_COLLISIONS: &str = "passages in which a ball touches the ball ahead and the ball behind, over all passages";
pub(crate) const ENERGY_RESIDUAL: &str = "error of the energy balance over the sum of the absolute terms";
pub(crate) const ELLIPSE_EDGE: &str = "contact angle with the half length of the ellipse over the radius of the ball, |α| + a/R; beyond the shoulder the ellipse is cut off; in space";
pub(crate) const FORCE_ANGLE: &str = "angle between the sum of all forces of the balls there and the radius, each in its meridian plane and positive on the side of the contact sign of its row; of a run in space";
pub(crate) const FTF: &str = "fundamental train frequency: orbits of the ball set per second";
pub(crate) const KEEPS: &str = "at no tilt, by linear interpolation between the loads of the list; none if the balls keep as much under every load, or if a run before it has no lag: `findings` has the reason";
pub(crate) const LAG: &str = "what a ball loses in one discrete raceway against its mean orbital speed outside, with a film against that of rolling: that speed times the time of the passage, less the angle of the raceway";
pub(crate) const LAG_FRACTION: &str = "lag per pass over that of rolling on rigid flanks without a contact angle";
pub(crate) const HERTZ_PRESSURE: &str = "largest pressure in the centre of a Hertz contact; ISO 76 allows 4200 MPa";
pub(crate) const MARGIN: &str = "distance of the value of the deciding criterion from its limit, 0.01 for each percentage point, of a contact pressure as a fraction of the limit; negative beyond the limit";
pub(crate) const PRESSURE_VELOCITY: &str = "largest product of contact pressure and sliding speed at one instant";
pub(crate) const REGULARISATION_SPEED: &str = "of all contacts under load with the raceways, of two contact points the more loaded one, in rolling; with `contact.regularisation = \"kalker\"`";
pub(crate) const SIMULATED: &str = "time at which the simulation ended";
pub(crate) const UNLOADED: &str = "the inner ring does not drive a ball then; 0 where it drives all of them all the time";
pub(crate) const STIFFNESS: &str = "K in F = K δ^1.5";
pub(crate) const VERDICT_NAMES: &str = "`smooth`, `double-collision`, `too-shallow`, `too-deep`, with a film `film-outweighs` and `film-queue`, `slips`, on elastic flanks and in space `loses-lag`, `overloaded`, `infeasible`, or `not-judged`";
