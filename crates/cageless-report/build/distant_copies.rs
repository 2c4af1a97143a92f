//! Copies over any distance, in front of gzip, which looks back 32 KiB. The engine has the same
//! stretches for every friction law and every kind of bearing, far apart.

use std::collections::HashMap;

/// Length of the shortest copy, bytes.
pub const SHORTEST: usize = 32;

/// `data` as commands and literals: the length of the commands as a little-endian `u32`; the
/// commands, each three numbers in LEB128, how many literals go before a copy, the length of the
/// copy less [`SHORTEST`], and how far back it begins; all literals.
pub fn with_distant_copies(data: &[u8]) -> Vec<u8> {
    let mut first_places: HashMap<&[u8], usize> = HashMap::new();
    let (mut commands, mut literals) = (vec![], vec![]);
    let (mut at, mut copied_to, mut entered_to) = (0, 0, 0);
    while at + SHORTEST <= data.len() {
        if let Some(&from) = first_places.get(&data[at..at + SHORTEST]) {
            let same = data[at..].iter().zip(&data[from..]);
            let length = same.take_while(|(a, b)| a == b).count();
            for number in [at - copied_to, length - SHORTEST, at - from] {
                push_leb128(&mut commands, number);
            }
            literals.extend_from_slice(&data[copied_to..at]);
            at += length;
            copied_to = at;
        } else {
            at += 1;
        }
        while entered_to < at && entered_to + SHORTEST <= data.len() {
            let stretch = &data[entered_to..entered_to + SHORTEST];
            first_places.entry(stretch).or_insert(entered_to);
            entered_to += 1;
        }
    }
    literals.extend_from_slice(&data[copied_to..]);
    let length = u32::try_from(commands.len()).expect("an engine of a few megabytes");
    [&length.to_le_bytes(), &commands[..], &literals[..]].concat()
}

fn push_leb128(bytes: &mut Vec<u8>, mut number: usize) {
    while number >= 0x80 {
        bytes.push((number & 0x7f) as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}
