//! A limited number of open connections; further ones wait. A connection on which no request begins in good
//! time is closed, so that silent ones lock nobody out.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::serve::Listener;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;
use tokio::time::timeout;

/// Connections that are open at once.
const CONNECTIONS_MAX: usize = 64;

/// Time that open answers get once the server ends.
pub const FAREWELL: Duration = Duration::from_secs(1);

/// Serves `app` until `ended`; the head of a request arrives within `arrival_max`.
pub async fn serve(
    mut listener: TcpListener,
    app: Router,
    arrival_max: Duration,
    ended: impl Future<Output = ()>,
) {
    let free = Arc::new(Semaphore::new(CONNECTIONS_MAX));
    let open = GracefulShutdown::new();
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new())
        .header_read_timeout(arrival_max);
    let mut ended = pin!(ended);
    loop {
        let accepted = async {
            // The semaphore is never closed.
            let permit = Arc::clone(&free).acquire_owned().await.ok();
            (Listener::accept(&mut listener).await, permit)
        };
        let ((stream, _), permit) = tokio::select! {
            accepted = accepted => accepted,
            () = &mut ended => break,
        };
        let app = TowerToHyperService::new(app.clone());
        let connection = open.watch(http.serve_connection(TokioIo::new(stream), app));
        tokio::spawn(async move {
            let _permit = permit;
            // What breaks a connection concerns nobody else.
            let _ = connection.await;
        });
    }
    // A connection that says nothing does not keep the server alive.
    let _ = timeout(FAREWELL, open.shutdown()).await;
}
