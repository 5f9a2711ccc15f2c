// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Guides are sessions: what a page shows, top to bottom, is what a shell prints in an empty folder.
//
//   <!-- file: NAME -->   the next fenced block is a file of the session
//   ```console            `$ COMMAND` lines, each followed by what it prints; a line `…` is any number of lines
//   ![…](images/NAME.png) an image that a command of the page made
//
// RIGOR_REWRITE_GOLDEN=1 writes what is printed and drawn into the pages; a block that matches keeps its `…`.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cli/program.h>
#include <rigor/view/image/picture.h>
#include <rigor/view/trace.h>
#include <support/corpus.h>

namespace rigor::test {
namespace {

const std::string kDocsFolder = std::string(RIGOR_SOURCE_DIR) + "/docs/";
constexpr std::string_view kAnyLines = "…";

/// Of 255. Which instructions Embree uses depends on the processor; a wrong image differs by tens.
constexpr double kMaxMeanDifference = 0.5;

bool rewrites_guides() { return std::getenv("RIGOR_REWRITE_GOLDEN") != nullptr; }

std::vector<std::string> guide_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string guide_text(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

using LineIterator = std::vector<std::string>::const_iterator;

bool guide_matches(LineIterator shown, LineIterator shown_end, LineIterator printed,
                   LineIterator printed_end) {
  for (; shown != shown_end; ++shown, ++printed) {
    if (*shown == kAnyLines) {
      for (LineIterator from = printed;; ++from) {
        if (guide_matches(shown + 1, shown_end, from, printed_end)) return true;
        if (from == printed_end) return false;
      }
    }
    if (printed == printed_end || *shown != *printed) return false;
  }
  return printed == printed_end;
}

class GuideSession {
 public:
  explicit GuideSession(const std::string& page)
      : page_(page), lines_(guide_lines(read_file(page))) {}

  void run() {
    std::string file;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::string line = lines_[i];
      kept_.push_back(line);
      constexpr std::string_view kFile = "<!-- file: ";
      if (line.starts_with(kFile)) {
        file = line.substr(kFile.size(), line.find(" -->") - kFile.size());
      } else if (line.starts_with("```")) {
        std::vector<std::string> block;
        while (++i < lines_.size() && lines_[i] != "```") block.push_back(lines_[i]);
        if (!file.empty()) {
          folder_.put(file, guide_text(block));
        } else if (line == "```console") {
          block = run_block(block);
        }
        file.clear();
        kept_.insert(kept_.end(), block.begin(), block.end());
        kept_.emplace_back("```");
      } else if (line.find("](images/") != std::string::npos) {
        compare_image(line.substr(line.find("](images/") + 9));
      }
    }
    if (rewrites_guides()) std::ofstream(page_, std::ios::binary) << guide_text(kept_);
  }

  int commands() const { return commands_; }

 private:
  std::vector<std::string> run_block(const std::vector<std::string>& block) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < block.size();) {
      EXPECT_TRUE(block[i].starts_with("$ ")) << page_ << ": " << block[i];
      const std::string command = block[i++].substr(2);
      std::vector<std::string> shown;
      while (i < block.size() && !block[i].starts_with("$ ")) shown.push_back(block[i++]);
      const std::vector<std::string> printed = run_command(command);
      const bool same = guide_matches(shown.begin(), shown.end(), printed.begin(), printed.end());
      if (!rewrites_guides()) {
        EXPECT_TRUE(same) << page_ << " shows\n"
                          << guide_text(shown) << "but `" << command << "` prints\n"
                          << guide_text(printed);
      }
      result.push_back("$ " + command);
      const auto& kept = same ? shown : printed;
      result.insert(result.end(), kept.begin(), kept.end());
    }
    return result;
  }

  std::vector<std::string> run_command(const std::string& command) {
    ++commands_;
    if (command == "echo $?") return {std::to_string(exit_)};
    folder_.put(".session.sh", command + "\n");
    const std::string programs = std::filesystem::path(RIGOR_BINARY).parent_path().string();
    const std::string shell = "cd '" + folder_.path("") + "' && HOME=$PWD RIGOR_CACHE=off PATH='" +
                              programs + "':$PATH sh .session.sh >.session.out 2>&1";
    const int status = std::system(shell.c_str());
    exit_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    EXPECT_TRUE(exit_ == 0 || exit_ == 1) << page_ << ": " << command << " exits with " << exit_;
    return guide_lines(folder_.get(".session.out"));
  }

  void compare_image(const std::string& rest) {
    const std::string name = rest.substr(0, rest.find(')'));
    const std::string committed = kDocsFolder + "images/" + name;
    const std::string made = folder_.get(name);
    const auto now = view::decode(made);
    ASSERT_TRUE(now) << page_ << ": no command makes " << name;
    const auto then = view::decode(read_file(committed));
    const bool same = then && then->width == now->width && then->height == now->height &&
                      mean_difference(*then, *now) <= kMaxMeanDifference;
    if (same) return;
    if (rewrites_guides()) {
      std::filesystem::create_directories(kDocsFolder + "images");
      std::ofstream(committed, std::ios::binary) << made;
    } else {
      ADD_FAILURE() << committed << " is not what `rigor` draws";
    }
  }

  static double mean_difference(const view::Picture& a, const view::Picture& b) {
    double sum = 0;
    for (unsigned y = 0; y < a.height; ++y) {
      for (unsigned x = 0; x < a.width; ++x) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          sum += std::abs(int{a.at(x, y)[channel]} - int{b.at(x, y)[channel]});
        }
      }
    }
    return sum / (3.0 * a.width * a.height);
  }

  std::string page_;
  std::vector<std::string> lines_;
  std::vector<std::string> kept_;
  Folder folder_;
  int exit_ = 0;
  int commands_ = 0;
};

class Guide : public ::testing::TestWithParam<std::string> {};

TEST_P(Guide, ShowsWhatIsPrinted) {
  if (view::tracer().empty()) GTEST_SKIP() << "Embree is not installed: nothing is drawn";
  GuideSession session(kDocsFolder + GetParam() + ".md");
  session.run();
  EXPECT_GE(session.commands(), 3);
}

INSTANTIATE_TEST_SUITE_P(Pages, Guide,
                         ::testing::Values("getting-started", "inertia", "meshes", "conversion",
                                           "diff", "edit"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(GuideMatching, AnEllipsisIsAnyNumberOfLines) {
  const auto match = [](const std::vector<std::string>& shown,
                        const std::vector<std::string>& printed) {
    return guide_matches(shown.begin(), shown.end(), printed.begin(), printed.end());
  };
  const std::string any(kAnyLines);
  EXPECT_TRUE(match({"a", any, "d"}, {"a", "b", "c", "d"}));
  EXPECT_TRUE(match({"a", any, "d"}, {"a", "d"}));
  EXPECT_TRUE(match({any}, {}));
  EXPECT_TRUE(match({any, "a", any, "b"}, {"a", "x", "a", "b"}));
  EXPECT_FALSE(match({"a", any, "d"}, {"a", "b", "c"}));
  EXPECT_FALSE(match({any, "a"}, {"a", "b"}));
  EXPECT_FALSE(match({"a"}, {}));
  EXPECT_FALSE(match({}, {"a"}));
}

}  // namespace
}  // namespace rigor::test
