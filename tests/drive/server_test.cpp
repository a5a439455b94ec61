// Would catch: a page that another site or another name for this machine can reach, a watcher taken
// for somebody with the token, a file of the machine that can be read, a flood that is obeyed; a
// mesh that holds commands up, fills the memory or is given to everybody; those with the token shut
// out by those without; a server that is busy with nothing but its want of file descriptors.
#include "drive/server.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

#include "../own_folder.hpp"

namespace treeline::drive {
namespace {

/// A connection of bytes to this machine.
class Connection {
 public:
  Connection() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {}
  explicit Connection(int port) : Connection() { connect(port); }
  void connect(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{5, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  }
  ~Connection() { ::close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void send(const std::string& bytes) {
    EXPECT_EQ(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }
  /// What comes until `end` has come, the other side closes, or 5 s have passed.
  std::string receive(const std::string& end, const std::string& after = "") {
    std::string text;
    char bytes[4096];
    const auto ended = [&] {
      const std::size_t at = text.find(after);
      return !end.empty() && at != std::string::npos && text.find(end, at) != std::string::npos;
    };
    while (!ended()) {
      const ssize_t count = ::recv(socket_, bytes, sizeof(bytes), 0);
      if (count <= 0) break;
      text.append(bytes, static_cast<std::size_t>(count));
    }
    return text;
  }
  std::size_t receive_some() {
    char bytes[65536];
    return static_cast<std::size_t>(std::max<ssize_t>(0, ::recv(socket_, bytes, sizeof(bytes), 0)));
  }

 private:
  int socket_;
};

/// A masked frame of text, as browsers send it.
std::string frame(const std::string& text) {
  std::string bytes = "\x81";
  if (text.size() < 126) {
    bytes += static_cast<char>(0x80 | text.size());
  } else {
    bytes += static_cast<char>(0x80 | 126);
    bytes += static_cast<char>(text.size() >> 8);
    bytes += static_cast<char>(text.size() & 255);
  }
  const std::string mask = "mask";
  bytes += mask;
  for (std::size_t i = 0; i < text.size(); ++i) bytes += static_cast<char>(text[i] ^ mask[i % 4]);
  return bytes;
}

class ServerTest : public treeline::test::OwnFolder {
 protected:
  void SetUp() override {
    OwnFolder::SetUp();
    ServerSettings settings;
    settings.token = "secret";
    settings.html = "<page>";
    settings.script = "script";
    settings.style = "style";
    settings.urdf = "<robot/>";
    settings.meshes = {{"a.stl", mesh_ = (root_ / "a.stl").string(), "", ""},
                       {"b.stl", "", "", ""},
                       {"large.stl", large_ = (root_ / "large.stl").string(), "", ""},
                       {"stalled.stl", stalled_ = (root_ / "stalled.stl").string(), "", ""}};
    std::ofstream(mesh_) << "solid";
    ServerHandlers handlers;
    handlers.join = [this](const NewFrontEnd& front_end, std::string& hello) {
      hello = front_end.may_command ? "hello commander" : "hello watcher";
      hello += front_end.mesh_query + ".";
      return ++joined_;
    };
    handlers.receive = [](int, std::string_view message) { return "got " + std::string(message); };
    handlers.leave = [this](int) { ++left_; };
    std::string error;
    server_ = Server::open(settings, handlers, error);
    ASSERT_NE(server_, nullptr) << error;
    host_ = "127.0.0.1:" + std::to_string(server_->port());
  }
  void TearDown() override {
    server_.reset();
    OwnFolder::TearDown();
  }

  std::string get(const std::string& target, const std::string& host,
                  const std::string& more = "") {
    Connection connection(server_->port());
    connection.send("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + more +
                    "Connection: close\r\n\r\n");
    return connection.receive("");
  }
  static std::string status(const std::string& response) { return response.substr(9, 3); }
  static std::string upgrade(const std::string& host, const std::string& query,
                             const std::string& more = "") {
    return "GET /socket" + query + " HTTP/1.1\r\nHost: " + host +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
           more + "\r\n";
  }

  /// Joins on `connection` and returns what stands behind the addresses of its meshes.
  std::string join(Connection& connection, const std::string& query = "") {
    connection.send(upgrade(host_, query));
    const std::string text = connection.receive(".", "hello");
    const std::size_t at = text.find("?pass=");
    return at == std::string::npos ? text : text.substr(at, text.find('.', at) - at);
  }
  /// A file of that many bytes without a place on the disk.
  static void make_large(const std::string& path, std::size_t bytes) {
    std::ofstream(path).close();
    std::filesystem::resize_file(path, bytes);
  }
  std::string request(const std::string& target) const {
    return "GET " + target + " HTTP/1.1\r\nHost: " + host_ + "\r\n\r\n";
  }

  std::string mesh_, large_, stalled_, host_;
  std::unique_ptr<Server> server_;
  std::atomic<int> joined_{0}, left_{0};
};

TEST_F(ServerTest, ServesThePageTheRobotAndItsMeshes) {
  EXPECT_NE(get("/?token=secret", host_).find("<page>"), std::string::npos);
  EXPECT_NE(get("/page.js", host_).find("script"), std::string::npos);
  EXPECT_NE(get("/robot.urdf", host_).find("<robot/>"), std::string::npos);
  EXPECT_NE(get("/mesh/0?token=secret", host_).find("solid"), std::string::npos);
  EXPECT_NE(get("/", host_).find("Content-Security-Policy"), std::string::npos);
}

TEST_F(ServerTest, ServesNothingElse) {
  for (const char* target : {"/mesh/1?token=secret", "/mesh/4", "/mesh/-1", "/mesh/0x0", "/mesh/",
                             "/mesh/0/../../etc/passwd", "/../../etc/passwd", "//etc/passwd",
                             "/mesh/..%2f..%2fetc%2fpasswd", "/etc/passwd", "/index.html",
                             "/socket", "/mesh/2?token=secret"}) {
    EXPECT_EQ(status(get(target, host_)), "404") << target;
  }
  Connection connection(server_->port());
  connection.send("POST / HTTP/1.1\r\nHost: " + host_ + "\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(status(connection.receive("")), "405");
}

TEST_F(ServerTest, RefusesOtherHostsAndOrigins) {
  const std::string port = std::to_string(server_->port());
  for (const std::string& host : {std::string("evil.example:") + port, std::string("127.0.0.1"),
                                  std::string("127.0.0.1:1"), std::string("10.0.0.1:") + port,
                                  std::string("127.0.0.1.evil.example:") + port, std::string()}) {
    EXPECT_EQ(status(get("/", host)), "403") << host;
  }
  EXPECT_EQ(status(get("/", "localhost:" + port)), "200");
  EXPECT_EQ(status(get("/", host_, "Origin: http://evil.example\r\n")), "403");
  EXPECT_EQ(status(get("/", host_, "Origin: null\r\n")), "403");
  EXPECT_EQ(status(get("/", host_, "Origin: http://" + host_ + "\r\n")), "200");
  for (const std::string& origin : {std::string("http://evil.example"), "https://" + host_}) {
    Connection connection(server_->port());
    connection.send(upgrade(host_, "?token=secret", "Origin: " + origin + "\r\n"));
    EXPECT_EQ(status(connection.receive("\r\n\r\n")), "403") << origin;
  }
  EXPECT_EQ(joined_, 0);
}

TEST_F(ServerTest, TheTokenDecidesWhoMayCommand) {
  for (const char* query :
       {"", "?token=", "?token=secre", "?token=secret2", "?token=Secret", "?x=1&token=secret"}) {
    Connection watcher(server_->port());
    watcher.send(upgrade(host_, query));
    EXPECT_NE(watcher.receive("watcher").find("hello watcher"), std::string::npos) << query;
  }
  Connection commander(server_->port());
  commander.send(upgrade(host_, "?token=secret"));
  EXPECT_NE(commander.receive("commander").find("hello commander"), std::string::npos);
  commander.send(frame("start"));
  EXPECT_NE(commander.receive("got start").find("got start"), std::string::npos);
}

// A message that is too long ends its connection, and no other.
TEST_F(ServerTest, BoundsMessagesAndSurvivesGarbage) {
  Connection good(server_->port());
  good.send(upgrade(host_, "?token=secret"));
  good.receive("commander");
  {
    Connection bad(server_->port());
    bad.send(upgrade(host_, "?token=secret"));
    bad.receive("commander");
    bad.send(frame(std::string(5000, 'x')));
    EXPECT_EQ(bad.receive("").find("got"), std::string::npos);
    Connection garbage(server_->port());
    garbage.send(std::string(20000, '\xff'));
    garbage.receive("");
    Connection silent(server_->port());
  }
  good.send(frame("still"));
  EXPECT_NE(good.receive("got still").find("got still"), std::string::npos);
}

// A picture in a page of another site asks as browsers do, from this machine.
TEST_F(ServerTest, NoOtherSiteLoadsAnything) {
  const std::string other = "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\n";
  for (const char* target : {"/", "/page.js", "/robot.urdf", "/mesh/0?token=secret"}) {
    EXPECT_EQ(status(get(target, host_, other)), "403") << target;
    EXPECT_EQ(status(get(target, host_, "Sec-Fetch-Site: same-site\r\n")), "403") << target;
    EXPECT_EQ(status(get(target, host_, "Sec-Fetch-Site: same-origin\r\n")), "200") << target;
  }
  const std::string link = "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\n";
  EXPECT_EQ(status(get("/?token=secret", host_, link)), "200");
  EXPECT_EQ(status(get("/mesh/0?token=secret", host_, link)), "403");
}

TEST_F(ServerTest, GivesMeshesWithTheTokenOrOnceToAFrontEnd) {
  for (const char* target : {"/mesh/0", "/mesh/0?token=", "/mesh/0?token=secre", "/mesh/0?pass="}) {
    EXPECT_EQ(status(get(target, host_)), "403") << target;
  }
  std::string withdrawn;
  {
    Connection watcher(server_->port());
    const std::string query = withdrawn = join(watcher);
    EXPECT_EQ(status(get("/mesh/0" + query, host_)), "200");
    EXPECT_EQ(status(get("/mesh/0" + query, host_)), "403");
  }
  Connection commander(server_->port());
  const std::string query = join(commander, "?token=secret");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(status(get("/mesh/0" + query, host_)), "200");
  while (left_ == 0) ::usleep(1000);
  EXPECT_EQ(status(get("/mesh/1" + withdrawn, host_)), "403");
}

// Readers that take nothing have 16 times 256 MiB under way. Nothing of it is held, and a command
// is answered before any has been sent whole.
TEST_F(ServerTest, HoldsLittleOfMeshesThatNobodyTakes) {
  constexpr std::size_t kBytes = 256U << 20U;
  make_large(large_, kBytes);
  const auto peak = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;  // MiB
  };
  const long before = peak();
  std::vector<std::unique_ptr<Connection>> readers;
  for (int i = 0; i < 16; ++i) {
    readers.push_back(std::make_unique<Connection>(server_->port()));
    readers.back()->send(request("/mesh/2?token=secret"));
  }
  for (const auto& reader : readers) EXPECT_EQ(status(reader->receive("\r\n\r\n")), "200");
  Connection commander(server_->port());
  join(commander, "?token=secret");
  commander.send(frame("stop"));
  EXPECT_NE(commander.receive("got stop").find("got stop"), std::string::npos);
  EXPECT_LT(peak() - before, 100) << "MiB: one of the meshes alone is 256";
  readers.resize(1);
  std::size_t taken = 0;
  while (taken < 4U << 20U) {
    const std::size_t count = readers[0]->receive_some();
    if (count == 0) break;
    taken += count;
  }
  EXPECT_GE(taken, 4U << 20U);
}

// Reading this mesh does not end, as on a disk that stalls.
TEST_F(ServerTest, AFileThatCannotBeReadHoldsNothingElse) {
  ASSERT_EQ(::mkfifo(stalled_.c_str(), 0600), 0);
  {
    Connection early(server_->port());
    join(early, "?token=secret");
    Connection reader(server_->port());
    reader.send(request("/mesh/3?token=secret"));
    early.send(frame("stop"));
    EXPECT_NE(early.receive("got stop").find("got stop"), std::string::npos);
    EXPECT_EQ(status(get("/", host_)), "200");
    Connection late(server_->port());
    join(late, "?token=secret");
    late.send(frame("start"));
    EXPECT_NE(late.receive("got start").find("got start"), std::string::npos);
  }
  int writer = -1;  // until somebody reads, nobody can write
  for (int i = 0; i < 5000 && writer < 0; ++i) {
    writer = ::open(stalled_.c_str(), O_WRONLY | O_NONBLOCK);
    if (writer < 0) ::usleep(1000);
  }
  EXPECT_GE(writer, 0);
  ::close(writer);
}

// Those who keep connections open and ask for nothing lose them to those who come.
TEST_F(ServerTest, IdleConnectionsShutNobodyOut) {
  std::vector<std::unique_ptr<Connection>> many;
  for (int i = 0; i < 100; ++i) {
    many.push_back(std::make_unique<Connection>(server_->port()));
    if (i % 10 == 0) EXPECT_EQ(status(get("/", host_)), "200") << i;
  }
  EXPECT_EQ(many.front()->receive(""), "") << "the oldest has been closed";
}

TEST_F(ServerTest, WatchersTakeNoPlaceOfThoseWithTheToken) {
  std::vector<std::unique_ptr<Connection>> watchers;
  for (int i = 0; i < kMostFrontEnds; ++i) {
    watchers.push_back(std::make_unique<Connection>(server_->port()));
    EXPECT_TRUE(join(*watchers.back()).starts_with("?pass=")) << i;
  }
  Connection one_more(server_->port());
  one_more.send(upgrade(host_, ""));
  EXPECT_EQ(status(one_more.receive("\r\n\r\n")), "503");
  EXPECT_EQ(server_->connections(), kMostFrontEnds);
  EXPECT_EQ(server_->commanders(), 0);
  std::vector<std::unique_ptr<Connection>> commanders;
  for (int i = 0; i < kMostFrontEnds; ++i) {
    commanders.push_back(std::make_unique<Connection>(server_->port()));
    EXPECT_TRUE(join(*commanders.back(), "?token=secret").starts_with("?pass=")) << i;
  }
  EXPECT_EQ(server_->commanders(), kMostFrontEnds);
  Connection too_many(server_->port());
  too_many.send(upgrade(host_, "?token=secret"));
  EXPECT_EQ(status(too_many.receive("\r\n\r\n")), "503");
}

// Joining costs the thread that serves who commands: it is rationed to those without the token.
TEST_F(ServerTest, WatchersJoinNoFasterThanTheyMay) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 200; ++i) {
    Connection watcher(server_->port());
    watcher.send(upgrade(host_, ""));
    watcher.receive("\r\n\r\n");
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  EXPECT_LE(joined_, 64 + 20.0 * passed.count() + 1);
  Connection commander(server_->port());
  EXPECT_TRUE(join(commander, "?token=secret").starts_with("?pass="));
}

// As many tries as pauses have passed, however fast or slow the machine is; then it goes on.
TEST_F(ServerTest, WaitsWhereNoFileDescriptorsAreLeft) {
  Connection early(server_->port());
  join(early, "?token=secret");
  Connection waiting;
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit few{std::min<rlim_t>(before.rlim_cur, 256), before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  std::vector<int> taken;
  for (int fd = ::dup(0); fd >= 0; fd = ::dup(0)) taken.push_back(fd);
  const auto begin = std::chrono::steady_clock::now();
  waiting.connect(server_->port());
  while (server_->failed_accepts() < 4) ::usleep(10000);
  early.send(frame("stop"));
  EXPECT_NE(early.receive("got stop").find("got stop"), std::string::npos);
  const int failed = server_->failed_accepts();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  EXPECT_LE(failed, 1 + passed.count() / 0.1);
  for (const int fd : taken) ::close(fd);
  ::setrlimit(RLIMIT_NOFILE, &before);
  waiting.send(request("/"));
  EXPECT_NE(waiting.receive("<page>").find("<page>"), std::string::npos);
}

}  // namespace
}  // namespace treeline::drive
