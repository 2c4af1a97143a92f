//! Whirl of a rotor in the bore of the inner ring, window by window.

use std::f64::consts::{PI, TAU};

use crate::contact_tracker::ContactCounts;
use crate::numerics::angle::wrap_angle_rad;

/// Motion of the journal round the centre of the bore in one interval of time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WhirlWindow {
    /// Start of the window, s.
    pub start_s: f64,
    /// End of the window, s.
    pub end_s: f64,
    /// Angle by which the journal has gone round, counter-clockwise, rad.
    pub turned_rad: f64,
    /// Sum of the absolute changes of that angle, rad.
    pub path_rad: f64,
    /// Smallest continuous angle of the journal from the bottom, rad.
    pub angle_min_rad: f64,
    /// Largest continuous angle of the journal from the bottom, rad.
    pub angle_max_rad: f64,
    /// Fraction of the time in contact.
    pub contact_fraction: f64,
    /// Mean contact force, N.
    pub force_mean_n: f64,
    /// Mean force on the rotor against its weight, friction included, N.
    pub lift_mean_n: f64,
    /// Contacts between balls that began.
    pub collisions: ContactCounts,
}

impl WhirlWindow {
    /// Whirl frequency, Hz, counter-clockwise positive.
    pub fn frequency_hz(&self) -> f64 {
        self.turned_rad / TAU / (self.end_s - self.start_s)
    }
}

/// Turns round the bore, all in one direction, from which a motion is a whirl.
pub(super) const WHIRL_TURNS: f64 = 1.0;
/// Fraction of the path round the bore that a whirl takes in its own direction at least.
pub(super) const ONE_WAY: f64 = 0.8;

/// Contact in a window from which the journal runs round the bore rather than bounces across it.
const ROUND_CONTACT: f64 = 0.95;

/// Whether the journal runs round the bore in a window, in lasting contact and in this sense.
fn runs_round(window: &WhirlWindow, sense: f64) -> bool {
    let turned = sense * window.turned_rad;
    let one_way = turned > 0.0 && turned >= ONE_WAY * window.path_rad;
    one_way && window.contact_fraction >= ROUND_CONTACT
}

/// Whirl in lasting contact, once round the bore at least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whirl {
    /// Time from which on the journal runs round the bore, s.
    pub from_s: f64,
    /// Time up to which it does, s.
    pub to_s: f64,
    /// Mean frequency, Hz, counter-clockwise positive.
    pub frequency_hz: f64,
    /// Largest magnitude of the frequency over a window, Hz.
    pub frequency_max_hz: f64,
    /// Largest mean contact force over a window, N.
    pub force_max_n: f64,
    /// Mean contact force of its last quarter over the largest of a quarter before; 1 of a single window.
    pub growth: f64,
}

/// Growth of the force over all quarters before, from which on it has not settled.
const GROWS: f64 = 1.1;

impl Whirl {
    /// Whirl in the last windows; `None` without one.
    pub(super) fn at_the_end(windows: &[WhirlWindow]) -> Option<Self> {
        let sense = windows.last()?.turned_rad.signum();
        let whirls = |w: &&WhirlWindow| runs_round(w, sense);
        let count = windows.iter().rev().take_while(whirls).count();
        Self::once_round(&windows[windows.len() - count..])
    }

    /// Longest whirl against `rotation`, with the largest frequency and force of all; `None` if the journal never
    /// whirls so.
    pub(super) fn backward(windows: &[WhirlWindow], rotation: f64) -> Option<Self> {
        let sense = -rotation.signum();
        let found = windows.split(|w| !runs_round(w, sense) || rotation == 0.0);
        let found: Vec<Self> = found.filter_map(Self::once_round).collect();
        let most = |of: fn(&Self) -> f64| found.iter().map(of).fold(0.0, f64::max);
        let longest = found.iter().max_by(|a, b| {
            let length_s = |whirl: &Self| whirl.to_s - whirl.from_s;
            length_s(a).total_cmp(&length_s(b))
        });
        longest.map(|longest| Self {
            frequency_max_hz: most(|whirl| whirl.frequency_max_hz),
            force_max_n: most(|whirl| whirl.force_max_n),
            ..*longest
        })
    }

    /// Whirl over all of these windows; `None` of less than once round the bore.
    fn once_round(windows: &[WhirlWindow]) -> Option<Self> {
        let turned: f64 = windows.iter().map(|w| w.turned_rad).sum();
        (turned.abs() >= WHIRL_TURNS * TAU).then(|| Self::over(windows))?
    }

    /// Motion over all of these windows; `None` without any.
    pub(super) fn over(windows: &[WhirlWindow]) -> Option<Self> {
        let most = |of: fn(&WhirlWindow) -> f64| windows.iter().map(of).fold(0.0, f64::max);
        Some(Self {
            from_s: windows.first()?.start_s,
            to_s: windows.last()?.end_s,
            frequency_hz: mean_frequency_hz(windows),
            frequency_max_hz: most(|w| w.frequency_hz().abs()),
            force_max_n: most(|w| w.force_mean_n),
            growth: growth(windows),
        })
    }

    /// Whether its force still grows.
    pub fn grows(&self) -> bool {
        self.growth > GROWS
    }
}

/// Mean force of the last quarter of the windows over the largest of a quarter before: a force that swings grows beyond
/// what it was at no time.
fn growth(windows: &[WhirlWindow]) -> f64 {
    let quarters = windows.rchunks(windows.len().div_ceil(4).max(1));
    let mut forces_n = quarters.map(|quarter| {
        let sum: f64 = quarter.iter().map(|w| w.force_mean_n).sum();
        sum / quarter.len() as f64
    });
    let last_n = forces_n.next().unwrap_or_default();
    let before_n = forces_n.reduce(f64::max);
    before_n.map_or(1.0, |before_n| last_n / before_n)
}

/// Contact in a window from which its motion is one in contact.
const MOSTLY_CONTACT: f64 = 0.5;

/// Largest mean whirl frequency against `rotation` in a window that is mostly in contact, Hz; 0 if there is none.
pub(super) fn backward_whirl_max_hz(windows: &[WhirlWindow], rotation: f64) -> f64 {
    let touching = windows.iter();
    touching
        .filter(|w| w.contact_fraction > MOSTLY_CONTACT)
        .map(|w| -w.frequency_hz() * rotation.signum())
        .fold(0.0, f64::max)
}

/// Mean whirl frequency over windows, Hz, counter-clockwise positive.
pub(super) fn mean_frequency_hz(windows: &[WhirlWindow]) -> f64 {
    let sum = |of: fn(&WhirlWindow) -> f64| windows.iter().map(of).sum::<f64>();
    sum(|w| w.turned_rad) / TAU / sum(|w| w.end_s - w.start_s)
}

/// Force of the inner ring on a journal.
#[derive(Debug, Clone, Copy)]
pub(super) struct JournalForce {
    /// Contact force, N.
    pub contact_n: f64,
    /// Upward force, N.
    pub lift_n: f64,
}

/// Divides the motion of the journal into windows of equal length.
#[derive(Debug, Clone, Default)]
pub(super) struct WhirlTracker {
    length_s: f64,
    angle_rad: Option<f64>,
    /// Whether the journal did not touch the bore in the last step, where it whirls only in contact.
    paused: bool,
    open: WhirlWindow,
    contact_s: f64,
    impulse_n_s: f64,
    lift_n_s: f64,
    collisions: ContactCounts,
    pub(super) windows: Vec<WhirlWindow>,
}

impl WhirlTracker {
    /// Windows of `length_s`.
    pub(super) fn new(length_s: f64) -> Self {
        Self {
            length_s,
            ..Self::default()
        }
    }

    fn empty(start_s: f64, angle_rad: f64) -> WhirlWindow {
        WhirlWindow {
            start_s,
            end_s: start_s,
            angle_min_rad: angle_rad,
            angle_max_rad: angle_rad,
            ..WhirlWindow::default()
        }
    }

    /// Takes the contacts between balls that began in the step of the next update.
    pub(super) fn collide(&mut self, collisions: ContactCounts) {
        self.collisions += collisions;
    }

    /// Takes the end of a step: unit vector from the centre of the bore to that of a journal that may
    /// run round it, time, length of the step, and forces.
    pub(super) fn update(
        &mut self,
        direction: Option<[f64; 2]>,
        time_s: f64,
        step_s: f64,
        pressed: &JournalForce,
    ) {
        // From −Y, counter-clockwise, as ψ.
        let kept = self.angle_rad.unwrap_or(0.0);
        let now = direction.map_or(kept, |[nx, ny]| nx.atan2(-ny));
        let after_a_pause = std::mem::replace(&mut self.paused, direction.is_none());
        let angle = match self.angle_rad {
            None => {
                self.open = Self::empty(time_s - step_s, now);
                now
            }
            Some(last) => last + wrap_angle_rad(now - last),
        };
        let change = angle - self.angle_rad.unwrap_or(angle);
        // A journal that passes the centre of the bore has no direction: such a leap is no whirl.
        if change.abs() < 0.5 * PI && !after_a_pause {
            self.open.turned_rad += change;
            self.open.path_rad += change.abs();
        }
        self.angle_rad = Some(angle);
        let w = &mut self.open;
        w.angle_min_rad = w.angle_min_rad.min(angle);
        w.angle_max_rad = w.angle_max_rad.max(angle);
        w.end_s = time_s;
        if pressed.contact_n > 0.0 {
            self.contact_s += step_s;
            self.impulse_n_s += pressed.contact_n * step_s;
            self.lift_n_s += pressed.lift_n * step_s;
        }
        if w.end_s - w.start_s >= self.length_s {
            self.close();
        }
    }

    /// Ends the open window.
    pub(super) fn close(&mut self) {
        let mut window = self.open;
        let length = window.end_s - window.start_s;
        if length > 0.0 {
            window.contact_fraction = (self.contact_s / length).min(1.0);
            window.force_mean_n = self.impulse_n_s / length;
            window.lift_mean_n = self.lift_n_s / length;
            window.collisions = std::mem::take(&mut self.collisions);
            self.windows.push(window);
        }
        self.open = Self::empty(window.end_s, self.angle_rad.unwrap_or(0.0));
        (self.contact_s, self.impulse_n_s, self.lift_n_s) = (0.0, 0.0, 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(contact_n: f64, lift_n: f64) -> JournalForce {
        JournalForce { contact_n, lift_n }
    }

    #[test]
    fn a_whirl_goes_round_in_contact_against_the_rotation() {
        let window = |turned_rad: f64, path_rad: f64, contact_fraction: f64| WhirlWindow {
            turned_rad,
            path_rad,
            contact_fraction,
            end_s: 0.01,
            ..WhirlTracker::empty(0.0, 0.0)
        };
        let round = window(-0.4 * TAU, 0.4 * TAU, 1.0);
        let of = |windows: &[WhirlWindow], rotation| {
            Whirl::backward(windows, rotation).map(|whirl| whirl.frequency_max_hz)
        };
        let close = |found: Option<f64>| (found.unwrap() - 40.0).abs() < 1e-9;
        assert!(close(of(&[round; 3], 100.0)));
        let mirrored = window(0.4 * TAU, 0.4 * TAU, 1.0);
        assert!(close(of(&[mirrored; 3], -100.0)));
        assert_eq!(of(&[round; 3], -100.0), None);
        assert_eq!(of(&[round; 3], 0.0), None);
        // One that has died away has been one.
        let rest = window(0.0, 0.0, 1.0);
        assert!(close(of(&[round, round, round, rest, rest], 100.0)));
        // Less than one round; a swing; a bounce; two halves with a swing between them.
        assert_eq!(of(&[round; 2], 100.0), None);
        assert_eq!(of(&[window(-0.4 * TAU, TAU, 1.0); 3], 100.0), None);
        assert_eq!(of(&[window(-0.4 * TAU, 0.4 * TAU, 0.6); 3], 100.0), None);
        assert_eq!(of(&[round, round, mirrored, round, round], 100.0), None);
    }

    /// From the last swing on, in one sense, and once round the bore at least; the force of its second half grows or
    /// does not.
    #[test]
    fn the_whirl_at_the_end_begins_after_the_last_swing() {
        let window = |k: u32, turns: f64, force_mean_n: f64| WhirlWindow {
            turned_rad: turns * TAU,
            path_rad: turns.abs() * TAU,
            contact_fraction: 1.0,
            start_s: 0.005 * f64::from(k),
            end_s: 0.005 * f64::from(k + 1),
            force_mean_n,
            ..WhirlWindow::default()
        };
        let swing = [window(0, -0.4, 9.0), window(1, 0.2, 9.0)];
        let of = |forces: [f64; 4]| {
            let whirl = (2..).zip(forces).map(|(k, force)| window(k, -0.5, force));
            let windows: Vec<_> = swing.into_iter().chain(whirl).collect();
            Whirl::at_the_end(&windows)
        };
        let whirl = of([2.0, 3.0, 5.0, 8.0]).unwrap();
        assert_eq!((whirl.from_s, whirl.to_s), (0.01, 0.03));
        assert_eq!(whirl.force_max_n, 8.0);
        assert!((whirl.frequency_hz + 100.0).abs() < 1e-9);
        assert!(whirl.grows() && !of([2.0, 6.0, 8.0, 8.5]).unwrap().grows());
        // One that dies away and swings does not, whatever its last windows do.
        let forces = [9.0, 8.0, 9.0, 7.0, 3.0, 7.0, 3.0, 5.0];
        let decays = (0..).zip(forces).map(|(k, force)| window(k, -0.5, force));
        let decays: Vec<_> = decays.collect();
        assert!(!Whirl::at_the_end(&decays).unwrap().grows());
        // Not once round; out of contact.
        assert_eq!(Whirl::at_the_end(&swing), None);
        let mut last = window(2, -3.0, 1.0);
        last.contact_fraction = 0.9;
        assert_eq!(Whirl::at_the_end(&[last]), None);
        assert_eq!(Whirl::at_the_end(&[]), None);
    }

    /// The largest backward turn of a window in contact: neither that of a journal in free flight, which passes the
    /// centre of the bore, nor one with the rotation.
    #[test]
    fn the_largest_backward_whirl_is_one_in_contact() {
        let window = |turns: f64, contact_fraction: f64| WhirlWindow {
            turned_rad: turns * TAU,
            contact_fraction,
            end_s: 0.005,
            ..WhirlTracker::empty(0.0, 0.0)
        };
        let windows = [
            window(-0.45, 0.2),
            window(-0.4, 0.49),
            window(-0.1, 0.51),
            window(-0.05, 1.0),
            window(0.3, 1.0),
        ];
        let close = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        };
        // Turns over 5 ms.
        close(backward_whirl_max_hz(&windows, 100.0), 20.0);
        close(backward_whirl_max_hz(&windows, -100.0), 60.0);
        close(backward_whirl_max_hz(&windows[..2], 100.0), 0.0);
        close(backward_whirl_max_hz(&windows[4..], 100.0), 0.0);
    }

    #[test]
    fn a_steady_whirl_has_its_frequency() {
        let mut tracker = WhirlTracker::new(0.01);
        let (rate, step) = (-TAU * 150.0, 1e-5);
        for k in 1..=3000 {
            let time = f64::from(k) * step;
            let (sin, cos) = (rate * time).sin_cos();
            tracker.collide(ContactCounts {
                all: u64::from(k % 100 == 0),
                above: [u64::from(k % 200 == 0), 0, 0],
            });
            tracker.update(Some([cos, sin]), time, step, &force(10.0, -3.0));
        }
        tracker.close();
        assert_eq!(tracker.windows.len(), 3);
        for window in &tracker.windows[1..] {
            assert!((window.frequency_hz() + 150.0).abs() < 1e-6);
            assert!((window.path_rad + window.turned_rad).abs() < 1e-9);
            assert!((window.force_mean_n - 10.0).abs() < 1e-9);
            assert!((window.lift_mean_n + 3.0).abs() < 1e-9);
            assert!((window.contact_fraction - 1.0).abs() < 1e-9);
            assert_eq!(
                (window.collisions.all, window.collisions.above),
                (10, [5, 0, 0])
            );
        }
    }

    /// A journal that swings to and fro, in contact half of the time: what it turned, its path and
    /// its ends are told apart, and so are the windows.
    #[test]
    fn every_number_of_a_window() {
        let mut tracker = WhirlTracker::new(0.02);
        let step = 1e-4;
        let begun = ContactCounts {
            all: 7,
            above: [5, 3, 2],
        };
        for k in 1..=330u32 {
            let time = f64::from(k) * step;
            // Up by 1.2 rad to 0.01 s, down by 2 rad to 0.02 s, then at rest.
            let angle = match k {
                0..=100 => 3.0 + 1.2 * f64::from(k) / 100.0,
                101..=200 => 4.2 - 2.0 * f64::from(k - 100) / 100.0,
                _ => 2.2,
            };
            tracker.collide(match k {
                150 => begun,
                _ => ContactCounts::default(),
            });
            let bounce_n = match k {
                0..=100 => 40.0,
                301..=330 => 7.0,
                _ => 0.0,
            };
            let direction = Some([angle.sin(), -angle.cos()]);
            tracker.update(direction, time, step, &force(bounce_n, 0.0));
        }
        tracker.close();
        tracker.close();
        let [first, second] = tracker.windows.as_slice() else {
            panic!("{:?}", tracker.windows)
        };
        let close = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        };
        close(first.start_s, 0.0);
        close(first.end_s, 0.02);
        // From the first update on, at 3.012 rad.
        close(first.turned_rad, -0.812);
        close(first.path_rad, 1.188 + 2.0);
        close(first.frequency_hz(), -0.812 / TAU / 0.02);
        // The first angle is between −π and π; the others are continuous with it.
        close(first.angle_min_rad, 2.2);
        close(first.angle_max_rad, 4.2);
        close(first.contact_fraction, 0.5);
        close(first.force_mean_n, 20.0);
        close(second.start_s, 0.02);
        close(second.end_s, 0.033);
        close(second.turned_rad, 0.0);
        close(second.angle_min_rad, 2.2);
        close(second.angle_max_rad, 2.2);
        close(second.contact_fraction, 30.0 / 130.0);
        close(second.force_mean_n, 7.0 * 30.0 / 130.0);
        assert_eq!(
            (first.collisions, second.collisions),
            (begun, ContactCounts::default())
        );
    }

    /// A step of more than a quarter turn is a passage by the centre and no whirl.
    #[test]
    fn leaps_across_the_bore_are_no_whirl() {
        let turned = |by: f64| {
            let mut tracker = WhirlTracker::new(1.0);
            for (k, angle) in [0.0, by, 2.0 * by].into_iter().enumerate() {
                tracker.update(
                    Some([angle.sin(), -angle.cos()]),
                    1e-3 * (k + 1) as f64,
                    1e-3,
                    &force(1.0, 0.0),
                );
            }
            tracker.close();
            tracker.windows[0].turned_rad
        };
        assert!((turned(1.5) - 3.0).abs() < 1e-9);
        assert_eq!(turned(1.6), 0.0);
        assert!((turned(-1.5) + 3.0).abs() < 1e-9);
        assert_eq!(turned(-1.6), 0.0);
    }
}
