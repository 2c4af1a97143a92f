//! The server of `cageless studio`: one page and its requests, on the loopback address, for who
//! has the token. It reads and writes no file.

mod client;
mod connections;
mod requests;

use std::net::{Ipv4Addr, SocketAddr};
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use axum::Router;
use axum::body::{Body, Bytes, to_bytes};
use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use cageless_live::{REQUEST_BYTES_MAX, Refusal, answered};
use cageless_study::pool;
use tokio::net::TcpListener;
use tokio::sync::{Semaphore, mpsc};
use tokio_stream::wrappers::ReceiverStream;

use crate::failure::Failure;
use crate::interrupt::StopFlag;
use client::{Client, Lines};
use connections::{FAREWELL, serve};

/// Threads that speak with the pages.
const WORKERS: usize = 2;
/// Requests that are computed at once; further ones are refused.
const COMPUTING_MAX: usize = 8;
/// Longest time that a request may take to arrive.
const ARRIVAL_MAX: Duration = Duration::from_secs(10);
/// Header that carries the token.
const TOKEN_HEADER: &str = "x-cageless-token";
/// The page runs its own inline scripts and the engine, and speaks with this server only.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; \
    style-src 'unsafe-inline'; worker-src blob:; connect-src 'self'; img-src data: blob:; \
    frame-ancestors 'none'; base-uri 'none'; form-action 'none'";

/// Secret of one server, in hexadecimal: 128 bits.
#[derive(Clone)]
pub struct Token(String);

impl Token {
    /// A token from the random source of the system.
    pub fn random() -> Result<Self, Failure> {
        let mut bytes = [0u8; 16];
        getrandom::fill(&mut bytes)
            .map_err(|e| Failure::Other(anyhow::anyhow!("no random numbers: {e}")))?;
        Ok(Self(bytes.iter().map(|b| format!("{b:02x}")).collect()))
    }

    /// Whether `given` is the token; the time does not depend on where they differ.
    fn is(&self, given: &str) -> bool {
        let (own, given) = (self.0.as_bytes(), given.as_bytes());
        own.len() == given.len() && own.iter().zip(given).fold(0, |d, (a, b)| d | (a ^ b)) == 0
    }
}

/// A server that is bound to a free port.
pub struct Server {
    listener: std::net::TcpListener,
    shared: Arc<Shared>,
}

struct Shared {
    port: u16,
    page: Bytes,
    token: Token,
    computing: Arc<Semaphore>,
    stop: StopFlag,
}

impl Server {
    /// Binds to a free port of the loopback address; the server ends once `stop` is set.
    pub fn bind(page: String, token: Token, stop: &StopFlag) -> Result<Self, Failure> {
        // Where there are no threads, the runtime would panic.
        drop(pool(NonZeroUsize::new(WORKERS + COMPUTING_MAX))?);
        let failed = |e: std::io::Error| {
            Failure::Other(anyhow::anyhow!("no port of 127.0.0.1 can be opened: {e}"))
        };
        let listener = std::net::TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, 0)))
            .map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let port = listener.local_addr().map_err(failed)?.port();
        let shared = Arc::new(Shared {
            port,
            page: page.into(),
            token,
            computing: Arc::new(Semaphore::new(COMPUTING_MAX)),
            stop: Arc::clone(stop),
        });
        Ok(Self { listener, shared })
    }

    /// Address with the token.
    pub fn address(&self) -> String {
        format!(
            "http://127.0.0.1:{}/?token={}",
            self.shared.port, self.shared.token.0
        )
    }

    /// Serves until the end.
    pub fn serve(self) -> Result<(), Failure> {
        let failed = |e: std::io::Error| Failure::Other(anyhow::anyhow!("the server failed: {e}"));
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(WORKERS)
            .max_blocking_threads(COMPUTING_MAX + 1)
            .enable_all()
            .build()
            .map_err(failed)?;
        let Self { listener, shared } = self;
        let stop = Arc::clone(&shared.stop);
        let app = Router::new()
            .route("/", get(page))
            .route("/request", post(request))
            .layer(middleware::from_fn_with_state(Arc::clone(&shared), guard))
            .with_state(shared);
        let ended = async move {
            while !stop.load(Ordering::Relaxed) {
                tokio::time::sleep(Duration::from_millis(50)).await;
            }
        };
        let served = runtime.block_on(async {
            let listener = TcpListener::from_std(listener)?;
            serve(listener, app, ARRIVAL_MAX, ended).await;
            Ok(())
        });
        runtime.shutdown_timeout(FAREWELL);
        served.map_err(failed)
    }
}

/// Refuses requests for another host or from another origin, or without the token.
async fn guard(State(shared): State<Arc<Shared>>, request: Request, next: Next) -> Response {
    let mut response = match refusal(&shared, &request) {
        // Who is refused keeps no connection open.
        Some((status, why)) => (status, [(header::CONNECTION, "close")], why).into_response(),
        None => next.run(request).await,
    };
    let headers = response.headers_mut();
    for (name, value) in [
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::CACHE_CONTROL, "no-store"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::X_FRAME_OPTIONS, "DENY"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

fn refusal(shared: &Shared, request: &Request) -> Option<(StatusCode, &'static str)> {
    let headers = request.headers();
    let own = [
        format!("127.0.0.1:{}", shared.port),
        format!("localhost:{}", shared.port),
    ];
    let text = |name: header::HeaderName| headers.get(name).map(|v| v.to_str().unwrap_or(""));
    // RFC 9112: one Host at most, and the authority of an absolute target goes before it.
    if headers.get_all(header::HOST).iter().count() > 1 {
        return Some((StatusCode::BAD_REQUEST, "a request has one Host header\n"));
    }
    // A foreign name that leads to 127.0.0.1 is no name of this server.
    let target = request.uri().authority().map(|a| a.as_str());
    let host = target.or(text(header::HOST));
    if !host.is_some_and(|host| own.iter().any(|o| o == host)) {
        return Some((
            StatusCode::MISDIRECTED_REQUEST,
            "not a name of this server\n",
        ));
    }
    let foreign = |origin: &str| !own.iter().any(|o| origin == format!("http://{o}"));
    if text(header::ORIGIN).is_some_and(foreign) {
        return Some((
            StatusCode::FORBIDDEN,
            "requests of other pages are refused\n",
        ));
    }
    if !given_token(headers, request.uri().query()).is_some_and(|t| shared.token.is(t)) {
        return Some((
            StatusCode::FORBIDDEN,
            "open the address that `cageless studio` printed: it carries the token\n",
        ));
    }
    None
}

fn given_token<'a>(headers: &'a HeaderMap, query: Option<&'a str>) -> Option<&'a str> {
    let in_query = || {
        let mut pairs = query?.split('&');
        pairs.find_map(|pair| pair.strip_prefix("token="))
    };
    match headers.get(TOKEN_HEADER) {
        Some(value) => value.to_str().ok(),
        None => in_query(),
    }
}

async fn page(State(shared): State<Arc<Shared>>) -> Response {
    let html = [(header::CONTENT_TYPE, "text/html; charset=utf-8")];
    (html, shared.page.clone()).into_response()
}

/// Answers with lines of JSON: progress, then the answer.
async fn request(State(shared): State<Arc<Shared>>, request: Request) -> Response {
    // A page of another origin can send a form or plain text without asking, but no token.
    if !request.headers().contains_key(TOKEN_HEADER) {
        let why = "requests carry the token in the header X-Cageless-Token\n";
        return (StatusCode::FORBIDDEN, why).into_response();
    }
    let body = tokio::time::timeout(
        ARRIVAL_MAX,
        to_bytes(request.into_body(), REQUEST_BYTES_MAX),
    );
    let body = match body.await {
        Err(_) => {
            return (StatusCode::REQUEST_TIMEOUT, "the request took too long\n").into_response();
        }
        Ok(Err(_)) => {
            let why = format!("a request has at most {REQUEST_BYTES_MAX} bytes\n");
            return (StatusCode::PAYLOAD_TOO_LARGE, why).into_response();
        }
        Ok(Ok(body)) => body,
    };
    let Ok(text) = String::from_utf8(body.into()) else {
        return (StatusCode::BAD_REQUEST, "a request is UTF-8 text\n").into_response();
    };
    let Ok(permit) = Arc::clone(&shared.computing).try_acquire_owned() else {
        let why = format!("{COMPUTING_MAX} requests are being computed: try again later\n");
        return (StatusCode::SERVICE_UNAVAILABLE, why).into_response();
    };
    let (lines, answers) = mpsc::channel(64);
    let stop = Arc::clone(&shared.stop);
    tokio::spawn(async move {
        let progress = lines.clone();
        let work = tokio::task::spawn_blocking(move || {
            let _permit = permit;
            compute(&text, &progress, &stop)
        });
        let failed = |_| failure("the engine failed on this request");
        let answer = work.await.unwrap_or_else(failed);
        let _ = lines.send(Ok((answer + "\n").into())).await;
    });
    let kind = [(header::CONTENT_TYPE, "application/x-ndjson")];
    (kind, Body::from_stream(ReceiverStream::new(answers))).into_response()
}

/// Computes one answer; a page that goes away, the end of the server, or too much time cancels it.
fn compute(text: &str, lines: &Lines, stop: &StopFlag) -> String {
    let seconds = requests::seconds_max(text);
    let client = Client::new(lines, stop, Duration::from_secs(seconds));
    let answer = requests::answer(text, &client);
    if answer.starts_with("{\"ok\"") {
        return answer;
    }
    if stop.load(Ordering::Relaxed) {
        return failure("the server of cageless studio has ended");
    }
    if client.late() {
        return failure(&format!(
            "ended after {seconds} s, the longest that this server computes one request: use the \
             command of the same name"
        ));
    }
    answer
}

fn failure(message: &str) -> String {
    answered(Err(Refusal::new(message)))
}
