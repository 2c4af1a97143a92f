//! The queue into which the balls of a conventional ring run.

/// Ball at the head of the queue of balls with these drifts, of any unit; ball k + 1 is ahead of ball k.
///
/// The mean drift of every group at the head is at most that of all balls, so that none leaves the queue. The cycle
/// lemma (Dvoretzky and Motzkin 1947) says that one such ball exists, and of drifts in general position only one.
///
/// # Panics
/// If there is no ball.
pub(crate) fn leading_ball(drifts: &[f64]) -> usize {
    let count = drifts.len();
    let mean = drifts.iter().sum::<f64>() / count as f64;
    // From ball N backwards, the head follows the place at which the sum of the drifts is largest.
    let (mut sum, mut most, mut head) = (0.0, 0.0, count - 1);
    for k in (0..count).rev() {
        sum += drifts[k] - mean;
        if sum > most && k > 0 {
            (most, head) = (sum, k - 1);
        }
    }
    head
}

#[cfg(test)]
mod tests {
    use super::leading_ball;
    use crate::numerics::random::RandomStream;

    #[test]
    fn no_group_at_the_head_is_faster_than_all_balls() {
        let mut stream = RandomStream::new(5, 1, 0, 0);
        for count in 2..20 {
            let drifts: Vec<f64> = (0..count).map(|_| stream.normal()).collect();
            let mean = drifts.iter().sum::<f64>() / count as f64;
            let stays = |head: usize| {
                (1..count).all(|group| {
                    let of_group = (0..group).map(|k| drifts[(head + count - k) % count]);
                    of_group.sum::<f64>() / group as f64 <= mean
                })
            };
            let heads: Vec<usize> = (0..count).filter(|head| stays(*head)).collect();
            assert_eq!(heads, [leading_ball(&drifts)], "{drifts:?}");
        }
    }
}
