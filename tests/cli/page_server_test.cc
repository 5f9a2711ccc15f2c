// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The page's server as clients of any manners see it: those that are slow, many, or done with sending.

#include <watch/page_server.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::tool {
namespace {

class ServedPage : public ::testing::Test {
 protected:
  ServedPage() : port_(std::stoi(server_.address().substr(17))) {
    server_.publish({"<html/>", "{}"});
    thread_ = std::thread([this] { server_.run(); });
    EXPECT_NE(read_to(asking("/"), "").find("<html/>"), std::string::npos);
  }
  ~ServedPage() override {
    server_.stop();
    thread_.join();
    for (const int socket : sockets_) ::close(socket);
  }

  int asking(const std::string& path, const std::string& head = "") {
    const int socket = sockets_.emplace_back(::socket(AF_INET, SOCK_STREAM, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    EXPECT_EQ(::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    const std::string request = "GET " + path +
                                " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n" +
                                head + "\r\n";
    EXPECT_EQ(::send(socket, request.data(), request.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(request.size()));
    return socket;
  }

  /// What comes until the server ends, or until `word` was in it.
  static std::string read_to(int socket, const std::string& word) {
    std::string text;
    std::vector<char> bytes(1 << 20U);
    while (word.empty() || text.find(word) == std::string::npos) {
      const ssize_t count = ::recv(socket, bytes.data(), bytes.size(), 0);
      if (count <= 0) break;
      text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

  PageServer server_{0};
  int port_;
  std::vector<int> sockets_;
  std::thread thread_;
};

TEST_F(ServedPage, AnswersWhoHasEndedItsSideOfTheConnection) {
  for (const char* path : {"/", "/data"}) {
    const int socket = asking(path);
    ::shutdown(socket, SHUT_WR);
    EXPECT_TRUE(read_to(socket, "").starts_with("HTTP/1.1 200 OK\r\n")) << path;
  }
  const int listener = asking("/events");
  ::shutdown(listener, SHUT_WR);
  EXPECT_NE(read_to(listener, ": here\n\n").find("text/event-stream"), std::string::npos);
  server_.tell("changed", "{}");
  EXPECT_NE(read_to(listener, "{}").find("event: changed\ndata: {}\n\n"), std::string::npos);
}

TEST_F(ServedPage, SaysWhatABrowserMayDoWithIt) {
  const std::string answer =
      read_to(asking("/", "Accept-Encoding: gzip, br\r\nRange: bytes=1-2\r\n"), "");
  for (const char* line :
       {"HTTP/1.1 200 OK", "Content-Length: 7", "Cache-Control: no-store",
        "X-Content-Type-Options: nosniff", "X-Frame-Options: DENY", "Connection: close",
        "Cross-Origin-Resource-Policy: same-origin", "Content-Type: text/html; charset=utf-8"}) {
    EXPECT_NE(answer.find(std::string(line) + "\r\n"), std::string::npos) << line << answer;
  }
  EXPECT_TRUE(answer.ends_with("\r\n\r\n<html/>")) << answer;
}

TEST_F(ServedPage, AListenerThatDoesNotReadMissesOldEvents) {
  const int slow = asking("/events");
  read_to(slow, ": here\n\n");
  // More than the system holds for a connection.
  const std::string large(1 << 20U, 'x');
  constexpr std::size_t kReported = 5 * PageServer::kMaxEvents;
  for (std::size_t i = 0; i < kReported; ++i) {
    server_.tell("changed", std::to_string(i) + large);
  }
  server_.tell("last", "end");
  const std::string heard = read_to(slow, "data: end\n\n");
  EXPECT_TRUE(heard.ends_with("event: last\ndata: end\n\n"));
  EXPECT_LT(heard.size(), kReported / 2 * large.size());
}

TEST_F(ServedPage, ListenersAreBounded) {
  std::vector<int> listeners;
  for (std::size_t i = 0; i <= PageServer::kMaxListeners; ++i) {
    listeners.push_back(asking("/events"));
    read_to(listeners.back(), ": here\n\n");
  }
  EXPECT_EQ(read_to(listeners.front(), "").find("data:"), std::string::npos) << "it is let go";
  server_.tell("changed", "{}");
  EXPECT_NE(read_to(listeners.back(), "{}").find("data: {}"), std::string::npos);
  EXPECT_NE(read_to(asking("/"), "").find("<html/>"), std::string::npos) << "others are answered";
}

TEST_F(ServedPage, AnEndlessRequestIsRefused) {
  const std::string answer = read_to(
      asking("/", "Cookie: " + std::string(8000, 'x') + "\r\nCookie: " + std::string(8000, 'x') +
                      "\r\nCookie: " + std::string(8000, 'x') + "\r\n"),
      "");
  EXPECT_EQ(answer.find("200 OK"), std::string::npos);
}

TEST_F(ServedPage, ATakenPortIsRefused) {
  EXPECT_THROW(PageServer(static_cast<std::uint16_t>(port_)), std::exception);
}

}  // namespace
}  // namespace rigor::tool
