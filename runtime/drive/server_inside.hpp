#pragma once

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <list>
#include <map>
#include <memory>
#include <thread>

#include "drive/mesh_passes.hpp"
#include "drive/rate_limit.hpp"
#include "drive/server.hpp"

namespace treeline::drive {

class FrontEndSocket;
class Visitor;

/// Three kinds of work, so that none waits for another: a thread for front ends, whose commands
/// have to be in time; one for those who ask for pages; one that reads files.
struct Server::Inside {
  using Executor = boost::asio::io_context::executor_type;

  Inside(ServerSettings s, ServerHandlers h)
      : settings(std::move(s)), handlers(std::move(h)), passes(settings.meshes.size()) {}
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  ~Inside();

  ServerSettings settings;
  ServerHandlers handlers;
  MeshPasses passes;
  // What connections use when they end is declared before the contexts, which end them.
  std::map<int, std::weak_ptr<FrontEndSocket>> sockets;  // only in the thread of front ends
  std::atomic<int> watchers{0}, commanders{0};           // places that are taken
  std::atomic<int> joined{0}, joined_commanders{0};
  std::atomic<int> failed_accepts{0};
  std::list<std::weak_ptr<Visitor>> visitors;  // the oldest first; only in the thread of pages
  RateLimit joins = rate_of_watchers();        // only in the thread of pages
  int port = 0;

  boost::asio::io_context front_ends{1};
  boost::asio::io_context pages{1};
  boost::asio::executor_work_guard<Executor> keep{front_ends.get_executor()};
  boost::asio::ip::tcp::acceptor acceptor{pages};
  boost::asio::steady_timer again{pages};
  boost::asio::thread_pool files{1};
  std::thread obeying, paging;

  /// Begins to accept and to run, in threads of its own.
  void run();
  void accept();
  /// Takes a place of a front end for as long as its socket lives. False: there is none left, or
  /// too many come without the token.
  bool take_place(bool may_command);
  void leave_place(bool may_command);

 private:
  void welcome(boost::asio::ip::tcp::socket socket);
  bool make_room();
};

}  // namespace treeline::drive
