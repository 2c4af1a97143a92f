//! `cageless studio`: what it answers, what it refuses, and that it lives.
#![cfg(unix)]

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use crate::common::studio::Studio;
use crate::common::{call, repository_case};

#[test]
fn the_page_and_its_requests_are_answered() {
    let studio = Studio::start();
    let (status, page) = studio.send("GET", &format!("/?token={}", studio.token), &[], "");
    assert_eq!(status, 200);
    let lower = page.to_lowercase();
    for header in [
        "content-security-policy: default-src 'none'",
        "referrer-policy: no-referrer",
    ] {
        assert!(lower.contains(header), "{header}");
    }
    assert!(page.contains("Zhao 2022, structure (d)") && page.contains("data-studio"));
    let case = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let body = serde_json::json!({ "op": "static", "case": case }).to_string();
    let own = format!("http://127.0.0.1:{}", studio.port);
    let headers = [
        ("X-Cageless-Token", studio.token.as_str()),
        ("Origin", &own),
    ];
    let (status, answer) = studio.send("POST", "/request", &headers, &body);
    assert!(
        status == 200 && answer.contains("inner_pressure_max_mpa"),
        "{answer}"
    );
}

#[test]
fn hostile_requests_are_refused_and_the_server_lives() {
    let studio = Studio::start();
    let token = studio.token.as_str();
    let page = format!("/?token={token}");
    let wrong = "0".repeat(32);
    let local = format!("localhost:{}", studio.port);
    let with = [("X-Cageless-Token", token)];
    let about = r#"{"op":"about"}"#;
    // No token, a wrong one, one in the address where the header is needed.
    assert_eq!(studio.send("GET", "/", &[], "").0, 403);
    assert_eq!(
        studio.send("GET", &format!("/?token={wrong}"), &[], "").0,
        403
    );
    assert_eq!(
        studio
            .send("POST", "/request", &[("X-Cageless-Token", &wrong)], about)
            .0,
        403
    );
    assert_eq!(
        studio
            .send("POST", &format!("/request?token={token}"), &[], about)
            .0,
        403
    );
    // A page of somebody else, and a name of somebody else that leads here.
    for origin in [
        "http://evil.example",
        "null",
        "http://127.0.0.1:1",
        "https://127.0.0.1",
    ] {
        let headers = [with[0], ("Origin", origin)];
        assert_eq!(
            studio.send("POST", "/request", &headers, about).0,
            403,
            "{origin}"
        );
    }
    for host in [
        "evil.example",
        "127.0.0.1",
        "127.0.0.1:1",
        "127.0.0.1.evil.example:80",
        "",
    ] {
        let headers = [with[0], ("Host", host)];
        assert_eq!(
            studio.send("POST", "/request", &headers, about).0,
            421,
            "{host}"
        );
    }
    assert_eq!(studio.send("GET", &page, &[("Host", &local)], "").0, 200);
    // Two names, of which servers take one or the other; and a target that is another server's.
    let head = format!("X-Cageless-Token: {token}\r\nContent-Length: 14\r\nHost: {local}\r\n");
    let two = format!("POST /request HTTP/1.1\r\n{head}Host: evil.example\r\n\r\n{about}");
    assert_eq!(studio.raw(two.as_bytes()).0, 400);
    let foreign = format!("POST http://evil.example/request HTTP/1.1\r\n{head}\r\n{about}");
    assert_eq!(studio.raw(foreign.as_bytes()).0, 421);
    // Nothing but the page is there: no file, inside the folder or outside.
    for path in [
        "/Cargo.toml",
        "/../../etc/passwd",
        "/%2e%2e/%2e%2e/etc/passwd",
        "//etc/passwd",
    ] {
        let (status, answer) = studio.send("GET", &format!("{path}?token={token}"), &[], "");
        assert_eq!(status, 404, "{path}: {answer}");
    }
    assert_eq!(studio.send("DELETE", &page, &[], "").0, 405);
    // Malformed messages.
    for body in [
        "{",
        "[]",
        "\u{0}",
        r#"{"op":"geometry","case":7}"#,
        r#"{"op":"shell"}"#,
    ] {
        let (status, answer) = studio.send("POST", "/request", &with, body);
        assert!(
            status == 200 && answer.contains("\"error\":{"),
            "{body}: {answer}"
        );
    }
    for bytes in [
        &b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc"[..],
        b"GET\r\n\r\n",
        b"\r\n\r\n\r\n",
    ] {
        assert!(matches!(studio.raw(bytes).0, 0 | 400), "{bytes:?}");
    }
    let deep = format!(r#"{{"op":"geometry","case":{}}}"#, "[".repeat(100_000));
    assert!(
        studio
            .send("POST", "/request", &with, &deep)
            .1
            .contains("\"error\":{")
    );
    studio.lives();
}

#[test]
fn a_body_of_100_mb_is_refused() {
    let studio = Studio::start();
    let mut stream = studio.connect();
    let head = format!(
        "POST /request HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\nX-Cageless-Token: {}\r\n\
         Content-Length: 104857600\r\n\r\n",
        studio.port, studio.token
    );
    stream.write_all(head.as_bytes()).unwrap();
    let block = vec![b' '; 1 << 20];
    let sent = (0..100)
        .take_while(|_| stream.write_all(&block).is_ok())
        .count();
    let mut answer = String::new();
    let _ = stream.read_to_string(&mut answer);
    // The refusal may be lost when the server closes while the client is still sending.
    assert!(
        sent < 100 || answer.contains(" 413 "),
        "{sent} MB were taken: {answer}"
    );
    studio.lives();
}

#[test]
fn a_thousand_connections_at_once_do_not_end_the_server() {
    let studio = Studio::start();
    // Some say nothing, some stop in the middle of a request.
    let open: Vec<TcpStream> = (0..1000)
        .map_while(|k| {
            // Beyond its limit and the queue of the system the server lets connections wait.
            let address = ([127, 0, 0, 1], studio.port).into();
            let mut stream =
                TcpStream::connect_timeout(&address, Duration::from_millis(300)).ok()?;
            if k % 2 == 0 {
                stream.write_all(b"POST /request HTTP/1.1\r\nHost: ").ok()?;
            }
            Some(stream)
        })
        .collect();
    assert!(open.len() > 100, "{}", open.len());
    drop(open);
    studio.lives();
}

/// Connections that never finish their first request, and such that were refused, lock nobody out.
#[test]
fn silent_connections_do_not_lock_out() {
    let studio = Studio::start();
    let begun = Instant::now();
    let open: Vec<TcpStream> = (0..64)
        .map(|k| {
            let mut stream = studio.connect();
            let part: &[u8] = match k % 3 {
                0 => b"GET / HTTP/1.1\r\n",
                1 => b"\r\n\r\n",
                _ => b"GET / HTTP/1.1\r\nHost: nobody\r\n\r\n",
            };
            stream.write_all(part).unwrap();
            stream
        })
        .collect();
    studio.lives();
    assert!(begun.elapsed() < Duration::from_secs(20), "{begun:?}");
    drop(open);
}

#[test]
fn an_interrupt_ends_the_server_with_a_computation_and_an_idle_connection() {
    let mut studio = Studio::start();
    let case = std::fs::read_to_string(repository_case("zhao-d.toml")).unwrap();
    let body = serde_json::json!({ "op": "verdict", "case": case }).to_string();
    let _idle = studio.connect();
    let busy = studio.begin(&body);
    let mut line = String::new();
    let mut answer = BufReader::new(&busy);
    while !line.contains("progress") {
        line.clear();
        assert!(
            answer.read_line(&mut line).expect("progress") > 0,
            "the answer ended"
        );
    }
    let pid = i32::try_from(studio.process.id()).unwrap();
    let killed = std::process::Command::new("kill")
        .args(["-INT", &pid.to_string()])
        .status();
    assert!(killed.expect("kill").success());
    let began = Instant::now();
    let status = studio.process.wait().expect("ends");
    assert!(status.success(), "{status}");
    assert!(
        began.elapsed() < Duration::from_secs(10),
        "{:?}",
        began.elapsed()
    );
}

#[test]
fn a_case_that_is_refused_starts_no_server() {
    let answer = call(&["studio", "no-such-file.toml"]);
    assert_eq!(answer.code, Some(2), "{}", answer.stderr);
    assert!(
        answer.stderr.contains("no-such-file.toml"),
        "{}",
        answer.stderr
    );
}
