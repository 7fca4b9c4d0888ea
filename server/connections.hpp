// The two kinds of clients, each behind a socket that has been accepted or opened.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>

#include "server/access.hpp"
#include "server/connection.hpp"
#include "server/page_files.hpp"

namespace pal::server {

/// JSON-RPC over a WebSocket, and files for a browser. Refuses a Host and an Origin that the rules do not
/// allow. Both outlive the connection.
ConnectionPointer web_socket_connection(ConnectionContext& connection_context, const AccessRules& rules,
                                        const PageFiles& files, boost::asio::ip::tcp::socket socket);

/// Lines over TCP.
ConnectionPointer line_connection(ConnectionContext& connection_context, boost::asio::ip::tcp::socket socket);

/// Lines over a terminal or a serial port, which stays open when a client goes: the next one shows the token
/// again.
ConnectionPointer line_connection(ConnectionContext& connection_context,
                                  boost::asio::posix::stream_descriptor line);

}  // namespace pal::server
