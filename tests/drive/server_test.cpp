// Would catch: a page that another site or another name for this machine can reach, a watcher taken
// for somebody with the token, a file of the machine that can be read, a flood that is obeyed.
#include "drive/server.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "../own_folder.hpp"
#include "drive/find_meshes.hpp"

namespace treeline::drive {
namespace {

/// A connection of bytes to this machine.
class Connection {
 public:
  explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
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
  std::string receive(const std::string& end) {
    std::string text;
    char bytes[4096];
    while (end.empty() || text.find(end) == std::string::npos) {
      const ssize_t count = ::recv(socket_, bytes, sizeof(bytes), 0);
      if (count <= 0) break;
      text.append(bytes, static_cast<std::size_t>(count));
    }
    return text;
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
    settings.meshes = {{"a.stl", mesh_ = (root_ / "a.stl").string()}, {"b.stl", ""}};
    std::ofstream(mesh_) << "solid";
    ServerHandlers handlers;
    handlers.join = [this](bool may_command, std::string& hello) {
      hello = may_command ? "hello commander" : "hello watcher";
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

  std::string mesh_, host_;
  std::unique_ptr<Server> server_;
  std::atomic<int> joined_{0}, left_{0};
};

TEST_F(ServerTest, ServesThePageTheRobotAndItsMeshes) {
  EXPECT_NE(get("/?token=secret", host_).find("<page>"), std::string::npos);
  EXPECT_NE(get("/page.js", host_).find("script"), std::string::npos);
  EXPECT_NE(get("/robot.urdf", host_).find("<robot/>"), std::string::npos);
  EXPECT_NE(get("/mesh/0", host_).find("solid"), std::string::npos);
  EXPECT_NE(get("/", host_).find("Content-Security-Policy"), std::string::npos);
}

TEST_F(ServerTest, ServesNothingElse) {
  for (const char* target :
       {"/mesh/1", "/mesh/2", "/mesh/-1", "/mesh/0x0", "/mesh/", "/mesh/0/../../etc/passwd",
        "/../../etc/passwd", "//etc/passwd", "/mesh/..%2f..%2fetc%2fpasswd", "/etc/passwd",
        "/index.html", "/socket"}) {
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

TEST_F(ServerTest, OnlySomeCanConnect) {
  std::vector<std::unique_ptr<Connection>> many;
  for (int i = 0; i < 40; ++i) many.push_back(std::make_unique<Connection>(server_->port()));
  EXPECT_EQ(get("/", host_), "");
  many.clear();
  std::string page;
  for (int i = 0; i < 50 && page.empty(); ++i) {
    page = get("/", host_);
    if (page.empty()) ::usleep(20000);
  }
  EXPECT_NE(page.find("<page>"), std::string::npos);
}

TEST(OwnHost, AcceptsNumbersWhereOthersMayConnect) {
  EXPECT_TRUE(is_own_host("10.1.2.3:80", "0.0.0.0", 80));
  EXPECT_TRUE(is_own_host("[fe80::1]:80", "::", 80));
  EXPECT_FALSE(is_own_host("robot.example:80", "0.0.0.0", 80));
  EXPECT_FALSE(is_own_host("10.1.2.3:80", "127.0.0.1", 80));
  EXPECT_NE(make_token(), make_token());
}

class MeshTest : public treeline::test::OwnFolder {};

// A URDF can name any file; only meshes inside of its own folder or package are found.
TEST_F(MeshTest, FindsOnlyMeshesBelowTheirFolder) {
  namespace fs = std::filesystem;
  fs::create_directories(root_ / "arm/urdf");
  fs::create_directories(root_ / "arm/meshes");
  for (const char* name :
       {"arm/meshes/a.stl", "arm/urdf/b.DAE", "secret.stl", "arm/urdf/key.txt"}) {
    std::ofstream(root_ / name) << "x";
  }
  fs::create_symlink(root_ / "secret.stl", root_ / "arm/urdf/link.stl");
  const std::string urdf =
      "<mesh filename=\"package://arm/meshes/a.stl\"/><mesh scale='1 1 1' filename='b.DAE'/>"
      "<mesh filename='../../secret.stl'/><mesh filename='link.stl'/><mesh filename='key.txt'/>"
      "<mesh filename='/etc/passwd'/><mesh filename='package://arm/../secret.stl'/>"
      "<mesh filename='package://other/c.stl'/><mesh filename='package://../secret.stl'/>"
      "<mesh filename=\"package://arm/meshes/a.stl\"/>";
  const auto meshes = find_meshes(urdf, root_ / "arm/urdf", {});
  ASSERT_EQ(meshes.size(), 9U);
  for (const ServedMesh& mesh : meshes) {
    const bool wanted = mesh.uri == "package://arm/meshes/a.stl" || mesh.uri == "b.DAE";
    EXPECT_EQ(!mesh.path.empty(), wanted) << mesh.uri << ": " << mesh.path;
  }
  const auto given = find_meshes("<mesh filename='package://other/c.stl'/>", root_,
                                 {{"other", root_ / "arm/meshes"}});
  EXPECT_TRUE(given[0].path.empty());
  std::ofstream(root_ / "arm/meshes/c.stl") << "x";
  EXPECT_FALSE(find_meshes("<mesh filename='package://other/c.stl'/>", root_,
                           {{"other", root_ / "arm/meshes"}})[0]
                   .path.empty());
}

}  // namespace
}  // namespace treeline::drive
