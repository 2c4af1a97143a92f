//! The form in which pages hold their engine leads back to it.

#[path = "../build/distant_copies.rs"]
mod written;

use written::{SHORTEST, with_distant_copies};

/// What the page does (`withoutCopies` in `engine.js`).
fn without_copies(packed: &[u8]) -> Vec<u8> {
    let length = u32::from_le_bytes(packed[..4].try_into().unwrap()) as usize;
    let (mut commands, mut literals) = packed[4..].split_at(length);
    let mut number = || {
        let (mut value, mut shift) = (0, 0);
        loop {
            let (byte, rest) = commands.split_first()?;
            commands = rest;
            value |= usize::from(byte & 0x7f) << shift;
            shift += 7;
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
    };
    let mut data = vec![];
    while let (Some(before), Some(longer), Some(back)) = (number(), number(), number()) {
        let (taken, rest) = literals.split_at(before);
        data.extend_from_slice(taken);
        literals = rest;
        for _ in 0..longer + SHORTEST {
            data.push(data[data.len() - back]);
        }
    }
    data.extend_from_slice(literals);
    data
}

#[test]
fn copies_lead_back_to_the_data() {
    // Bytes without any stretch twice, by a linear congruential generator.
    let mut state = 1_u32;
    let unlike: Vec<u8> = (0..70_000)
        .map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        })
        .collect();
    let far_apart = [&unlike[..], &unlike[100..50_000], b"end"].concat();
    let one_byte = vec![7; 1000];
    for (data, most) in [
        (&unlike[..], unlike.len() + 4),
        (&far_apart[..], unlike.len() + 40),
        (&one_byte[..], 2 * SHORTEST),
        (&unlike[..SHORTEST - 1], SHORTEST + 3),
        (&[], 4),
    ] {
        let packed = with_distant_copies(data);
        assert!(packed.len() <= most, "{} of {}", packed.len(), data.len());
        assert_eq!(without_copies(&packed), data);
    }
}
