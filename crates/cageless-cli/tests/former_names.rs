//! A file with former names of keys is a case, with a note on stderr.

use crate::common::{call, call_on, repository_case};

#[test]
fn a_former_key_is_read_with_a_note_that_names_the_present_one() {
    let text = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let former = text.replace("\ndamping_n_s_m1_5 = ", "\ndamping = ");
    assert_ne!(former, text);
    let line = 1 + former
        .lines()
        .position(|l| l.starts_with("damping ="))
        .unwrap();
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("former.toml");
    std::fs::write(&path, &former).unwrap();
    let (now, then) = (
        call_on("static", &repository_case("zhao-d.toml"), &[], &["--json"]),
        call_on("static", &path, &[], &["--json"]),
    );
    assert_eq!(then.code, Some(0), "{then:?}");
    assert_eq!(then.stdout, now.stdout);
    let note = format!(
        "note: {}:{line}: contact.damping is now contact.damping_n_s_m1_5",
        path.display()
    );
    assert!(then.stderr.contains(&note), "{}", then.stderr);
    assert_eq!(then.stderr.matches("note:").count(), 1, "{}", then.stderr);
    assert_eq!(now.stderr, "");

    let file = path.to_str().unwrap();
    let quiet = call(&["static", file, "--quiet", "--json"]);
    assert_eq!((quiet.stderr.as_str(), quiet.stdout), ("", now.stdout));
    let set = call_on(
        "check",
        &repository_case("zhao-d.toml"),
        &["solver.method=symplectic"],
        &[],
    );
    assert_eq!(set.code, Some(0), "{set:?}");
    let note = "note: --set solver.method=symplectic: solver.method = \"symplectic\" is now";
    assert!(set.stderr.contains(note), "{}", set.stderr);
}
