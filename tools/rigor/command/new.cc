// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor new NAME`: the folder of a model that begins right, from a template, or a ROS 2 package of a robot.

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <sys/stat.h>

#include <rigor/author/scaffold.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "completion/completion.h"
#include "output/atomic_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_folder(const std::string& path, int error) {
  throw UsageError(path + ": cannot be created: " + std::generic_category().message(error));
}

/// A folder beside the one that it is to become; what is in it is gone unless it becomes that.
class FolderInTheMaking {
 public:
  explicit FolderInTheMaking(const std::string& target)
      : target_(target), path_(join_path(parent_path(target), ".rigor-new-XXXXXX")) {
    if (::mkdtemp(path_.data()) == nullptr) refuse_folder(target_, errno);
  }
  ~FolderInTheMaking() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  FolderInTheMaking(const FolderInTheMaking&) = delete;
  FolderInTheMaking& operator=(const FolderInTheMaking&) = delete;

  void put(const author::ScaffoldFile& file) const {
    const std::string path = join_path(path_, file.path);
    std::error_code error;
    fs::create_directories(std::string(parent_path(path)), error);
    if (error) refuse_folder(target_, error.value());
    replace_file(path, file.bytes);
  }

  /// Whatever has come to stand there meanwhile stays.
  void finish() {
    // mkdtemp's folder is its owner's alone; this one is to be as any other.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::chmod(path_.c_str(), 0777U & ~mask) != 0 ||
        ::rename(path_.c_str(), target_.c_str()) != 0) {
      refuse_folder(target_, errno);
    }
    path_.clear();
  }

 private:
  std::string target_;
  std::string path_;
};

class New final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(
        program, "new", "Create a folder with a new model, complete and explained",
        {"rigor new my_robot", "rigor new my_arm --template arm", "rigor new my_robot --ros2"});
    app->add_option("name", name_, "The model's name, and its folder, which must not be there yet")
        ->required()
        ->type_name("NAME");
    CLI::Option* which =
        app->add_option("--template", template_, "What it begins as: " + templates_and_default())
            ->type_name("WHICH");
    offer(which, author::template_names());
    app->add_flag(
           "--ros2", ros2_,
           "Create the ROS 2 package NAME_description instead: xacro, ros2_control, a launch "
           "file, tests and a pre-commit hook")
        ->excludes(which);
    return app;
  }

  int run() override {
    choice("template", template_, author::template_names());
    while (name_.size() > 1 && name_.back() == '/') name_.pop_back();
    std::string name(file_name(name_));
    if (ros2_) {
      if (name.ends_with(author::kDescriptionSuffix)) {
        name.resize(name.size() - author::kDescriptionSuffix.size());
      }
      refuse_name(name, author::ros2_name_problem(name),
                  "a ROS 2 package's name has lowercase letters, digits and single underscores");
      name_ = join_path(parent_path(name_), name + std::string(author::kDescriptionSuffix));
      create(author::scaffold_ros2_package(name));
      say_what_next_in_package(name);
    } else {
      refuse_name(name, author::name_problem(name), "a model's name has letters, digits, _ and -");
      create(author::scaffold(template_, name));
      say_what_next(name);
    }
    return kClean;
  }

 private:
  void refuse_name(const std::string& name, const std::optional<author::NameProblem>& problem,
                   const std::string& what_is_taken) const {
    if (!problem) return;
    throw UsageError("the name \"" + name + "\" " + problem->what + ": " + what_is_taken +
                     ", and begins with a letter, as in " +
                     join_path(parent_path(name_), problem->suggestion));
  }

  void create(const std::vector<author::ScaffoldFile>& files) const {
    refuse_what_is_there();
    FolderInTheMaking folder(name_);
    for (const author::ScaffoldFile& file : files) folder.put(file);
    folder.finish();

    std::string made;
    for (const author::ScaffoldFile& file : files) made += join_path(name_, file.path) + "\n";
    write({0, {}}, made);
  }

  std::string templates_and_default() const {
    std::string text = listed(author::template_names());
    return text.insert(text.find(template_) + template_.size(), " (the default)");
  }

  void refuse_what_is_there() const {
    std::error_code ignored;
    if (fs::symlink_status(name_, ignored).type() != fs::file_type::not_found) {
      throw UsageError(name_ + ": already exists and is left unchanged");
    }
    const std::string parent(parent_path(name_));
    if (!parent.empty() && RealDisk().kind(parent) != PathKind::kFolder) {
      throw UsageError(parent + ": no such folder");
    }
  }

  static std::string quoted(const std::string& path) {
    const bool plain = path.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                           "0123456789_-./") == std::string::npos;
    return plain ? path : shell_quoted(path);
  }

  static void say_commands(std::initializer_list<std::string> lines) {
    for (const std::string& line : lines) say("  " + report::printable(line));
  }

  void say_what_next_in_package(const std::string& name) const {
    const std::string robot = quoted(join_path(name_, "urdf/" + name + ".urdf.xacro"));
    say("created the ROS 2 package " + name + std::string(author::kDescriptionSuffix) +
        "; what to try next:");
    say_commands({
        "rigor validate " + quoted(name_) + " --target ros",
        "rigor simulate " + robot,
        "rigor simulate --scenario " + quoted(join_path(name_, "test/drive.toml")),
        "rigor render " + robot + " -o " + quoted(name_ + ".png"),
        "colcon build --packages-select " + name + std::string(author::kDescriptionSuffix),
    });
  }

  void say_what_next(const std::string& name) const {
    const std::string folder = quoted(name_);
    const std::string above(parent_path(name_));
    const std::string models =
        above.empty() || above == "." ? "$PWD" : quoted(fs::absolute(above).string());
    say("created a model from the template " + template_ + "; what to try next:");
    say_commands({
        "rigor validate " + folder,
        "rigor inertia " + folder,
        "rigor simulate --scenario " + quoted(join_path(name_, "scenario.toml")),
        "rigor render " + folder + " -o " + quoted(name_ + ".png"),
        "GZ_SIM_RESOURCE_PATH=" + models + " gz sim " +
            quoted(join_path(name_, "worlds/" + name + ".sdf")),
    });
  }

  std::string name_;
  std::string template_ = "diff-drive";
  bool ros2_ = false;
};

}  // namespace

std::unique_ptr<Command> new_command() { return std::make_unique<New>(); }

}  // namespace rigor::tool
