// The two kinds of clients, each behind a socket that has been accepted or opened.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>

#include "server/access.hpp"
#include "server/connection.hpp"

namespace pal::server {

/// JSON-RPC over a WebSocket. Refuses a Host and an Origin that the rules do not allow, and every client if
/// the server is `full`.
ConnectionPointer web_socket_connection(ConnectionContext& connection_context, const AccessRules& rules,
                                        boost::asio::ip::tcp::socket socket, bool full);

/// Lines over TCP.
ConnectionPointer line_connection(ConnectionContext& connection_context, boost::asio::ip::tcp::socket socket);

/// Lines over a terminal or a serial port, which stays open when a client goes: the next one shows the token
/// again.
ConnectionPointer line_connection(ConnectionContext& connection_context,
                                  boost::asio::posix::stream_descriptor line);

}  // namespace pal::server
