//! A server of `cageless studio` and requests to it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::Duration;

use super::{cageless, repository_case};

/// A server on a case of the repository, which ends with the test.
pub struct Studio {
    pub process: Child,
    pub port: u16,
    pub token: String,
}

impl Studio {
    pub fn start() -> Self {
        let mut process = cageless()
            .arg("studio")
            .arg(repository_case("zhao-d.toml"))
            .arg("--no-browser")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("starts");
        let mut address = String::new();
        let out = process.stdout.take().expect("a pipe");
        BufReader::new(out)
            .read_line(&mut address)
            .expect("the address");
        let rest = address
            .trim()
            .strip_prefix("http://127.0.0.1:")
            .expect("the loopback address");
        let (port, token) = rest.split_once("/?token=").expect("a token");
        assert_eq!(token.len(), 32, "{address}");
        Self {
            port: port.parse().expect("a port"),
            token: token.to_owned(),
            process,
        }
    }

    pub fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).expect("connects");
        stream
            .set_read_timeout(Some(Duration::from_secs(30)))
            .unwrap();
        stream
    }

    /// Sends bytes and returns the status and everything that comes back.
    pub fn raw(&self, bytes: &[u8]) -> (u16, String) {
        let mut stream = self.connect();
        // A server that refuses may close before it has read everything.
        let _ = stream.write_all(bytes);
        let mut answer = vec![];
        let _ = stream.read_to_end(&mut answer);
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let status = answer.split(' ').nth(1).and_then(|s| s.parse().ok());
        (status.unwrap_or(0), answer)
    }

    pub fn send(
        &self,
        method: &str,
        path: &str,
        headers: &[(&str, &str)],
        body: &str,
    ) -> (u16, String) {
        let mut text = format!("{method} {path} HTTP/1.1\r\nConnection: close\r\n");
        if !headers.iter().any(|(name, _)| *name == "Host") {
            text += &format!("Host: 127.0.0.1:{}\r\n", self.port);
        }
        for (name, value) in headers {
            text += &format!("{name}: {value}\r\n");
        }
        if !body.is_empty() {
            text += &format!("Content-Length: {}\r\n", body.len());
        }
        self.raw(format!("{text}\r\n{body}").as_bytes())
    }

    /// The answer to a request of its page, which may take minutes to compute.
    pub fn ask(&self, body: &str) -> String {
        let mut stream = self.begin(body);
        let patience = Some(Duration::from_secs(300));
        stream.set_read_timeout(patience).expect("a timeout");
        let mut answer = vec![];
        let _ = stream.read_to_end(&mut answer);
        String::from_utf8_lossy(&answer).into_owned()
    }

    /// Sends a request of its page without waiting for the answer.
    pub fn begin(&self, body: &str) -> TcpStream {
        let mut stream = self.connect();
        let head = format!(
            "POST /request HTTP/1.1\r\nConnection: close\r\nHost: 127.0.0.1:{}\r\nX-Cageless-Token: {}\r\n\
             Content-Length: {}\r\n\r\n",
            self.port,
            self.token,
            body.len()
        );
        stream.write_all((head + body).as_bytes()).expect("sent");
        stream
    }

    /// The server answers a request of its own page.
    pub fn lives(&self) {
        let answer = self.ask(r#"{"op":"about"}"#);
        assert!(answer.starts_with("HTTP/1.1 200"), "{answer}");
        assert!(answer.contains("\"ok\":{"), "{answer}");
    }
}

impl Drop for Studio {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
