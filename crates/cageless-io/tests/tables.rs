//! Tables of sweeps come back as they were written.

use cageless_io::results::{Column, ColumnKind, Row, TableReader, TableWriter};
use cageless_results::Cell;

fn columns() -> Vec<Column> {
    let column = |name: &str, unit: &str, kind| Column {
        name: name.to_owned().into(),
        unit: unit.to_owned().into(),
        kind,
    };
    vec![
        column("variant", "", ColumnKind::Index),
        column("load_n", "N", ColumnKind::Number),
        column("balls", "", ColumnKind::Integer),
        column("profile", "", ColumnKind::Text),
        column("gaps_deg", "deg", ColumnKind::Numbers),
    ]
}

/// Every kind of cell, null and not, at the ends of lists and groups of rows.
fn row(k: i64) -> Row {
    let some = |every: i64, cell: Cell| if k % every == 0 { Cell::Null } else { cell };
    vec![
        Cell::Integer(k),
        some(3, Cell::Number(k as f64 / 7.0)),
        some(5, Cell::Integer(-k)),
        some(7, Cell::Text(format!("name {} é", k % 4))),
        some(
            4,
            Cell::Numbers((0..k % 6).map(|j| j as f64 - 0.5).collect()),
        ),
    ]
}

#[test]
fn every_kind_of_cell_comes_back() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("rows.parquet");
    let footer = [("plan", "a = 1\nb = \"ü\"".to_owned())];
    let mut writer = TableWriter::create(&path, &columns(), &footer).unwrap();
    let count = 40_000;
    (0..count).for_each(|k| writer.push(row(k)).unwrap());
    assert!(!path.exists());
    writer.finish().unwrap();

    let reader = TableReader::open(&path).unwrap();
    assert_eq!(reader.columns(), columns());
    assert_eq!(reader.rows(), count as u64);
    assert_eq!(reader.footer("plan"), Some("a = 1\nb = \"ü\""));
    assert_eq!(reader.footer("unit:gaps_deg"), Some("deg"));
    let names: Result<Vec<Row>, _> = reader.rows_of(&[3]).collect();
    assert!(
        names
            .unwrap()
            .into_iter()
            .eq((0..count).map(|k| vec![row(k)[3].clone()]))
    );
    // More than one group of rows.
    let rows: Result<Vec<Row>, _> = reader.into_rows().collect();
    assert!(rows.unwrap().into_iter().eq((0..count).map(row)));
}

#[test]
fn numbers_that_are_none_are_null_and_misfits_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("rows.parquet");
    let mut writer = TableWriter::create(&path, &columns(), &[]).unwrap();
    let mut odd = row(1);
    odd[1] = Cell::Number(f64::NAN);
    writer.push(odd).unwrap();
    writer.finish().unwrap();
    let reader = TableReader::open(&path).unwrap();
    assert_eq!(reader.into_rows().next().unwrap().unwrap()[1], Cell::Null);

    for (k, cell) in [
        (0, Cell::Null),
        (1, Cell::Integer(1)),
        (3, Cell::Number(1.0)),
    ] {
        let mut writer = TableWriter::create(&path, &columns(), &[]).unwrap();
        let mut wrong = row(1);
        wrong[k] = cell;
        assert!(writer.push(wrong).is_err());
    }
    // The one that was there still is.
    assert_eq!(TableReader::open(&path).unwrap().rows(), 1);
}

#[test]
fn what_is_no_table_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("rows.parquet");
    let message = |path| TableReader::open(path).err().expect("refused").to_string();
    assert!(message(&path).contains("cannot be read"));
    std::fs::write(&path, "no table").unwrap();
    assert!(message(&path).contains("cannot be read"));
}

/// Wherever bytes are overwritten, in the rows or in the footer, it is refused by name: Parquet
/// panics at some damaged footers and believes others.
#[test]
fn a_damaged_table_is_no_accident() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("rows.parquet");
    let mut writer = TableWriter::create(&path, &columns(), &[]).unwrap();
    (0..40).for_each(|k| writer.push(row(k)).unwrap());
    writer.finish().unwrap();
    let whole = std::fs::read(&path).unwrap();
    let read = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        let table = TableReader::open(&path)?;
        table.into_rows().try_for_each(|row| row.map(drop))
    };
    let refused = |bytes: &[u8], what: &str| {
        let message = read(bytes).expect_err(what).to_string();
        let named = "rows.parquet: cannot be read: ";
        assert!(message.contains(named), "{what}: {message}");
    };
    for at in 0..whole.len() {
        let fills: &[u8] = if at % 16 == 0 {
            &[0x00, 0x5a, 0xff]
        } else {
            &[]
        };
        for &fill in fills {
            let mut damaged = whole.clone();
            damaged[at..(at + 16).min(whole.len())].fill(fill);
            if damaged != whole {
                refused(&damaged, &format!("{fill} at {at}"));
            }
        }
        let mut damaged = whole.clone();
        damaged[at] ^= 1 << (at % 8);
        refused(&damaged, &format!("a bit at {at}"));
        if at % 4 == 0 {
            assert!(read(&whole[..at]).is_err(), "the first {at} bytes");
        }
    }
    assert!(read(&whole).is_ok());
}

/// A table whose checksum is right but which no program of ours has written.
#[test]
fn a_forged_table_and_one_without_a_checksum_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("rows.parquet");
    let mut writer = TableWriter::create(&path, &columns(), &[]).unwrap();
    (0..40).for_each(|k| writer.push(row(k)).unwrap());
    writer.finish().unwrap();
    let whole = std::fs::read(&path).unwrap();
    let find = |bytes: &[u8], text: &[u8]| bytes.windows(text.len()).rposition(|w| w == text);
    let key = find(&whole, b"file_crc32").unwrap();
    let open = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        TableReader::open(&path).map(drop)
    };
    // As an earlier version wrote it.
    let mut nameless = whole.clone();
    nameless[key] = b'F';
    let refused = open(&nameless).unwrap_err().to_string();
    assert!(refused.contains("lacks `file_crc32`") && refused.contains("earlier version"));

    // Bytes of the footer replaced, and the checksum made to fit.
    let (mut forged, mut refused) = (0, 0);
    let digits = key + b"file_crc32".len() + 2;
    let length: [u8; 4] = whole[whole.len() - 8..whole.len() - 4].try_into().unwrap();
    let footer = whole.len() - 8 - u32::from_le_bytes(length) as usize;
    for at in (footer..key).step_by(2) {
        for value in [0x03, 0xff] {
            let mut bytes = whole.clone();
            bytes[at] = value;
            bytes[digits..digits + 8].copy_from_slice(b"00000000");
            let checksum = format!("{:08x}", crc32fast::hash(&bytes));
            bytes[digits..digits + 8].copy_from_slice(checksum.as_bytes());
            forged += 1;
            refused += usize::from(open(&bytes).is_err());
        }
    }
    assert!(refused > forged / 10, "{refused} of {forged}");
}
