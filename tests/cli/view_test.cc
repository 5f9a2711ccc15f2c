// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor view` as its users script it, and as a browser asks it.

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <rigor/report/page/model_page.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

bool has_page() { return !report::page_template(report::PageUse::kFile).empty(); }

std::string viewed(const std::string& link) {
  return "<sdf version='1.9'><model name='m'><link name='" + link +
         "'><visual "
         "name='v'><geometry><sphere><radius>1</radius></sphere></geometry></visual></link>"
         "</model></sdf>\n";
}

class ViewCli : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_page()) GTEST_SKIP() << "built without node: there is no page";
    folder.put("arm/model.sdf", viewed("upper"));
  }

  Folder folder;
};

TEST(ViewWithoutNode, SaysWhatToDo) {
  if (has_page()) GTEST_SKIP() << "built with node";
  const Folder folder;
  folder.put("m.sdf", viewed("l"));
  const Ran ran = folder.rigor("view m.sdf");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("node"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("m.html")));
}

TEST_F(ViewCli, WritesOneWholePage) {
  const Ran ran = folder.rigor("view arm/model.sdf -o out.html");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("out.html is written"), std::string::npos) << ran.err;
  const std::string page = folder.get("out.html");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n")) << page.substr(page.size() - 40);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("connect-src"), std::string::npos);
  EXPECT_NE(page.find("\"m::upper\""), std::string::npos);
}

TEST_F(ViewCli, IsCalledLikeTheModel) {
  EXPECT_EQ(folder.rigor("view arm/model.sdf").exit, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path("arm.html")));
  EXPECT_EQ(folder.rigor("view arm/model.sdf").exit, 0);  // its own page is replaced
  folder.put("arm.html", "<p>mine</p>");
  const Ran ran = folder.rigor("view arm/model.sdf");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_EQ(folder.get("arm.html"), "<p>mine</p>");
}

TEST_F(ViewCli, InItsOwnFolderItIsCalledLikeTheFile) {
  folder.put("model.sdf", viewed("upper"));
  EXPECT_EQ(folder.rigor("view model.sdf").exit, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path("model.html")));
}

TEST_F(ViewCli, RefusesWhatCannotBe) {
  EXPECT_EQ(folder.rigor("view arm/model.sdf -o missing/out.html").exit, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path("missing")));
  EXPECT_EQ(folder.rigor("view none.sdf").exit, 2);
  EXPECT_EQ(folder.rigor("view arm/model.sdf --port 1234").exit, 2);
  EXPECT_EQ(folder.rigor("view arm/model.sdf --serve -o out.html").exit, 2);
  folder.put("notes.xml", "<notes/>");
  EXPECT_EQ(folder.rigor("view notes.xml -o notes.html").exit, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path("notes.html")));
}

TEST_F(ViewCli, ShowsADamagedFileWithItsFindings) {
  folder.put("cut.sdf", "<sdf version='1.9'><model name='m'><link name='whole'/>");
  EXPECT_EQ(folder.rigor("view cut.sdf").exit, 0);
  EXPECT_NE(folder.get("cut.html").find("\"rule\":\"xml-"), std::string::npos);
}

/// `rigor view --serve` in a folder.
class Served {
 public:
  Served(const Folder& folder, const char* model) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    const std::string where = folder.path("");
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::close(ends[0]);
      ::close(ends[1]);
      // Should it say nothing, the test fails and does not hang.
      ::alarm(60);
      if (::chdir(where.c_str()) == 0) {
        ::execl(RIGOR_BINARY, "rigor", "view", model, "--serve", nullptr);
      }
      ::_exit(99);
    }
    ::close(ends[1]);
    said_ = ::fdopen(ends[0], "r");
    const std::string line = next_line();
    const std::size_t at = line.find("http://127.0.0.1:");
    if (at != std::string::npos) port_ = std::atoi(line.c_str() + at + 17);
  }
  ~Served() {
    if (said_ != nullptr) std::fclose(said_);
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;

  std::string next_line() {
    std::array<char, 4096> line{};
    return std::fgets(line.data(), static_cast<int>(line.size()), said_) != nullptr ? line.data()
                                                                                    : "";
  }

  int port() const { return port_; }
  std::string own_host() const { return "127.0.0.1:" + std::to_string(port_); }

  /// A connection over which a request was sent.
  int ask(const std::string& path, const std::string& host,
          const std::string& method = "GET") const {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    EXPECT_EQ(::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    const std::string request = method + ' ' + path + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n";
    EXPECT_EQ(::send(socket, request.data(), request.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(request.size()));
    return socket;
  }

  /// What comes until the other side ends, or until `word` was in it.
  static std::string read_to(int socket, const std::string& word) {
    std::string text;
    std::array<char, 65536> bytes;
    while (word.empty() || text.find(word) == std::string::npos) {
      const ssize_t count = ::recv(socket, bytes.data(), bytes.size(), 0);
      if (count <= 0) break;
      text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

  std::string answer(const std::string& path, const std::string& host,
                     const std::string& method = "GET") const {
    const int socket = ask(path, host, method);
    const std::string text = read_to(socket, "");
    ::close(socket);
    return text;
  }

  int interrupt() {
    ::kill(pid_, SIGINT);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t pid_ = -1;
  std::FILE* said_ = nullptr;
  int port_ = 0;
};

TEST_F(ViewCli, ServesThisMachine) {
  Served served(folder, "arm/model.sdf");
  ASSERT_NE(served.port(), 0);
  const std::string page = served.answer("/", served.own_host());
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200 ")) << page.substr(0, 200);
  EXPECT_NE(page.find("connect-src 'self'"), std::string::npos);
  EXPECT_NE(page.find("\"live\":true"), std::string::npos);
  EXPECT_TRUE(page.ends_with("</html>\n"));
  const std::string data = served.answer("/data?x", "localhost:" + std::to_string(served.port()));
  EXPECT_TRUE(data.starts_with("HTTP/1.1 200 "));
  EXPECT_NE(data.find("\"m::upper\""), std::string::npos);
  EXPECT_TRUE(served.answer("/arm/model.sdf", served.own_host()).starts_with("HTTP/1.1 404 "));
  EXPECT_TRUE(served.answer("/", served.own_host(), "POST").starts_with("HTTP/1.1 405 "));
  EXPECT_EQ(served.interrupt(), 0);
}

TEST_F(ViewCli, RefusesAnotherHost) {
  Served served(folder, "arm/model.sdf");
  ASSERT_NE(served.port(), 0);
  const std::string port = std::to_string(served.port());
  for (const std::string& host : {"evil.example:" + port, std::string("127.0.0.1"),
                                  std::string("127.0.0.1:1"), "127.0.0.1:" + port + ".evil.example",
                                  "evil.example\r\nHost: 127.0.0.1:" + port, std::string()}) {
    for (const char* path : {"/", "/data", "/events"}) {
      const std::string answer = served.answer(path, host);
      EXPECT_TRUE(answer.starts_with("HTTP/1.1 40")) << host << answer.substr(0, 100);
      EXPECT_EQ(answer.find("upper"), std::string::npos) << host;
    }
  }
}

TEST_F(ViewCli, TellsWhatChanged) {
  Served served(folder, "arm/model.sdf");
  ASSERT_NE(served.port(), 0);
  const int events = served.ask("/events", served.own_host());
  EXPECT_NE(Served::read_to(events, "\r\n\r\n").find("text/event-stream"), std::string::npos);

  const auto put_at_once = [this](const std::string& text) {
    folder.put(".new", text);
    std::filesystem::rename(folder.path(".new"), folder.path("arm/model.sdf"));
  };
  put_at_once(viewed("lower"));
  const std::string changed = Served::read_to(events, "\"nothing\":");
  EXPECT_NE(changed.find("event: changed\ndata: {"), std::string::npos) << changed;
  EXPECT_NE(changed.find("link m::lower added"), std::string::npos) << changed;
  EXPECT_NE(served.next_line().find("link m::lower added"), std::string::npos);
  EXPECT_NE(served.answer("/data", served.own_host()).find("\"m::lower\""), std::string::npos);

  put_at_once(viewed("lower") + "<!-- the same -->\n");
  EXPECT_NE(Served::read_to(events, "\"nothing\":true").find("\"changes\":[]"), std::string::npos);

  // Who asked for the page before that and listens only now is told at once.
  const int late = served.ask("/events", served.own_host());
  EXPECT_NE(Served::read_to(late, "\"nothing\":true").find("event: changed"), std::string::npos);
  ::close(late);

  // While the file is away, the last model stays.
  std::filesystem::remove(folder.path("arm/model.sdf"));
  EXPECT_NE(Served::read_to(events, "model.sdf").find("\"nothing\":false"), std::string::npos);
  EXPECT_NE(served.answer("/data", served.own_host()).find("\"m::lower\""), std::string::npos);
  ::close(events);
}

}  // namespace
}  // namespace rigor::test
