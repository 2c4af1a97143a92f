//! Rows that others compute.

use std::fs;
use std::path::Path;

use cageless::simulation::Control;
use cageless_io::case_file::template;
use cageless_io::plan_file::PlanFile;
use cageless_study::StudyError;
use cageless_study::sweep::{Collection, Job, Sweep, merge, run, write_part};

/// The variants of [`sweep`].
const ALL: std::ops::Range<u64> = 0..7;

fn sweep(folder: &Path, seed: u64) -> Sweep {
    fs::write(folder.join("case.toml"), template(false)).expect("written");
    let plan = format!(
        "seed = {seed}\ncompute = [\"static\"]\ncase = \"case.toml\"\n[samples]\n\
         method = \"random\"\ncount = 7\n\
         operation.radial_load_n = {{ from = 500.0, to = 1500.0 }}"
    );
    let plan = PlanFile::parse(&plan, "plan", folder).expect("a plan");
    Sweep::new(plan).expect("a sweep")
}

fn part(sweep: &Sweep, range: std::ops::Range<u64>, folder: &Path) -> Vec<u8> {
    let path = folder.join("elsewhere.parquet");
    assert!(write_part(sweep, range, &path, &|| Control::Continue(())).expect("written"));
    fs::read(path).expect("read")
}

#[test]
fn parts_from_elsewhere_make_the_result_of_one_run() {
    let dir = tempfile::tempdir().expect("a folder");
    let sweep = sweep(dir.path(), 1);
    let alone = Job {
        result: dir.path().join("alone.parquet"),
        shard: None,
        threads: None,
    };
    run(&sweep, &alone, |_| Control::Continue(())).expect("computed");

    let result = dir.path().join("together.parquet");
    let collection = Collection::open(&sweep, &result, None).expect("opened");
    assert_eq!(collection.missing().expect("read"), vec![ALL]);
    let middle = part(&sweep, 2..5, dir.path());
    collection.add(2, &middle).expect("taken");
    assert_eq!(collection.missing().expect("read"), [0..2, 5..7]);
    // Nobody else may work on it; whoever comes later goes on.
    let busy = Collection::open(&sweep, &result, None).expect_err("in use");
    assert!(busy.to_string().contains("another process"), "{busy}");
    assert!(!collection.finish().expect("read"));
    assert!(!result.exists());

    let collection = Collection::open(&sweep, &result, None).expect("opened");
    for range in collection.missing().expect("read") {
        let path = collection.part(range.start);
        assert!(write_part(&sweep, range, &path, &|| Control::Continue(())).expect("written"));
    }
    assert!(collection.finish().expect("made"));
    assert_eq!(
        fs::read(result).expect("read"),
        fs::read(alone.result).expect("read")
    );
}

#[test]
fn merging_replaces_no_result_of_another_plan() {
    let dir = tempfile::tempdir().expect("a folder");
    let job = |name: &str, shard: Option<&str>| Job {
        result: dir.path().join(name),
        shard: shard.map(|s| s.parse().expect("a shard")),
        threads: None,
    };
    let (one, other) = (sweep(dir.path(), 1), sweep(dir.path(), 2));
    let result = dir.path().join("sweep.parquet");
    run(&one, &job("sweep.parquet", None), |_| Control::Continue(())).expect("computed");
    let before = fs::read(&result).expect("read");
    let shards = |sweep: &Sweep, name: &str| {
        ["1/2", "2/2"].map(|shard| {
            let job = job(&format!("{name}-{}", &shard[..1]), Some(shard));
            run(sweep, &job, |_| Control::Continue(())).expect("computed");
            job.result
        })
    };
    let own = shards(&one, "own");
    let error = merge(&shards(&other, "other"), &result).expect_err("another plan");
    let message = error.to_string();
    assert!(matches!(error, StudyError::Input(_)), "{message}");
    assert!(
        message.contains("sweep.parquet is of another plan: seed was 1, is 2"),
        "{message}"
    );
    assert!(fs::read(&result).expect("read") == before);
    // The same again is no harm; a shard in its place, or something else, is.
    assert_eq!(merge(&own, &result).expect("merged"), 7);
    assert!(fs::read(&result).expect("read") == before);
    for (content, why) in [
        (fs::read(&own[0]).expect("read"), "another part"),
        (b"a = 1\n".to_vec(), "cannot be read"),
    ] {
        fs::write(&result, &content).expect("written");
        let message = merge(&own, &result).expect_err("foreign").to_string();
        assert!(message.contains(why), "{message}");
        assert!(fs::read(&result).expect("read") == content);
    }
}

#[test]
fn a_part_of_another_sweep_is_refused_and_does_not_stay() {
    let dir = tempfile::tempdir().expect("a folder");
    let (one, other) = (sweep(dir.path(), 1), sweep(dir.path(), 2));
    let result = dir.path().join("result.parquet");
    let collection = Collection::open(&one, &result, None).expect("opened");
    let foreign = part(&other, ALL, dir.path());
    let error = collection.add(0, &foreign).expect_err("foreign");
    assert!(
        matches!(error, StudyError::Input(_)) && error.to_string().contains("seed"),
        "{error}"
    );
    assert!(collection.add(0, b"no table").is_err());
    assert_eq!(collection.missing().expect("read"), vec![ALL]);
}

/// The work folder of one plan takes no rows of another, nor what is no table of a sweep.
#[test]
fn parts_of_another_plan_are_refused() {
    let dir = tempfile::tempdir().expect("a folder");
    let (one, other) = (sweep(dir.path(), 1), sweep(dir.path(), 2));
    let result = dir.path().join("sweep.parquet");
    let collection = Collection::open(&one, &result, None).expect("opened");
    let foreign = part(&other, 2..5, dir.path());
    let file = collection.part(2);
    fs::write(&file, foreign).expect("written");
    let refused = collection.missing().expect_err("of another plan");
    let message = refused.to_string();
    assert!(matches!(refused, StudyError::Input(_)), "{message}");
    for said in ["rows-0000000002.parquet", "seed was 2, is 1", "Remove it"] {
        assert!(message.contains(said), "{message}");
    }
    drop(collection);
    let job = Job {
        result: result.clone(),
        shard: None,
        threads: None,
    };
    assert!(run(&one, &job, |_| Control::Continue(())).is_err());
    assert!(!result.exists());
    fs::remove_file(file).expect("removed");
    assert!(
        run(&one, &job, |_| Control::Continue(()))
            .expect("computed")
            .complete
    );
}
