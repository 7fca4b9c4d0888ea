// The code of Boost.Asio and Boost.Beast that is no template, compiled once for all files of the server.
#include <boost/asio/impl/src.hpp>
#include <boost/beast/src.hpp>
