// The two kinds of clients, each behind a socket that has been accepted or opened.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>

#include "runtime_system/private/client_at_door.hpp"
#include "runtime_system/rights.hpp"

namespace pal::runtime_system {

/// JSON-RPC over a WebSocket. Refuses a Host and an Origin that the doors do not allow, and everybody if the
/// server is `full`.
Entrance web_client(Hall& hall, const Doors& doors, boost::asio::ip::tcp::socket socket, bool full);

/// Lines over TCP.
Entrance line_client(Hall& hall, boost::asio::ip::tcp::socket socket);

/// Lines over a terminal or a serial port, which stays open when a client goes: the next one shows the token
/// again.
Entrance line_client(Hall& hall, boost::asio::posix::stream_descriptor line);

}  // namespace pal::runtime_system
