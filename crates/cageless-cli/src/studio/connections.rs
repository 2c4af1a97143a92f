//! A listener with a limited number of open connections; further ones wait. A connection that does
//! not begin with a request in good time is closed, so that silent ones lock nobody out.

use std::io;
use std::net::SocketAddr;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use axum::serve::Listener;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{Sleep, sleep};

/// Connections that are open at once.
const CONNECTIONS_MAX: usize = 64;

/// The listener.
pub struct Limited {
    listener: TcpListener,
    free: Arc<Semaphore>,
    arrival_max: Duration,
}

impl Limited {
    /// Limits `listener`; the head of the first request of a connection arrives within
    /// `arrival_max`.
    pub fn new(listener: TcpListener, arrival_max: Duration) -> Self {
        Self {
            listener,
            arrival_max,
            free: Arc::new(Semaphore::new(CONNECTIONS_MAX)),
        }
    }
}

impl Listener for Limited {
    type Io = Connection;
    type Addr = SocketAddr;

    async fn accept(&mut self) -> (Self::Io, Self::Addr) {
        // The semaphore is never closed.
        let permit = Arc::clone(&self.free).acquire_owned().await.ok();
        let (stream, address) = Listener::accept(&mut self.listener).await;
        let connection = Connection {
            stream,
            head: Some(Head::new(self.arrival_max)),
            _permit: permit,
        };
        (connection, address)
    }

    fn local_addr(&self) -> io::Result<Self::Addr> {
        self.listener.local_addr()
    }
}

/// The head of the first request of a connection, on its way.
struct Head {
    deadline: Pin<Box<Sleep>>,
    begun: bool,
    line_ends: u32,
}

impl Head {
    fn new(arrival_max: Duration) -> Self {
        Self {
            deadline: Box::pin(sleep(arrival_max)),
            begun: false,
            line_ends: 0,
        }
    }

    /// Whether these bytes complete it: an empty line after the first line.
    fn completed_by(&mut self, bytes: &[u8]) -> bool {
        bytes.iter().any(|byte| {
            match byte {
                b'\n' if self.begun => self.line_ends += 1,
                b'\n' | b'\r' => {}
                _ => (self.begun, self.line_ends) = (true, 0),
            }
            self.line_ends == 2
        })
    }
}

/// A connection that counts until it is closed.
pub struct Connection {
    stream: TcpStream,
    /// `None` once it has arrived.
    head: Option<Head>,
    _permit: Option<OwnedSemaphorePermit>,
}

impl AsyncRead for Connection {
    fn poll_read(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        let before = buffer.filled().len();
        let read = Pin::new(&mut self.stream).poll_read(cx, buffer);
        if let Some(head) = &mut self.head {
            if head.completed_by(&buffer.filled()[before..]) {
                self.head = None;
            } else if head.deadline.as_mut().poll(cx).is_ready() {
                return Poll::Ready(Err(io::ErrorKind::TimedOut.into()));
            }
        }
        read
    }
}

impl AsyncWrite for Connection {
    fn poll_write(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<io::Result<usize>> {
        Pin::new(&mut self.stream).poll_write(cx, bytes)
    }

    fn poll_flush(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(cx)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(cx)
    }
}
