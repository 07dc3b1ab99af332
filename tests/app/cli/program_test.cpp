#include "tests/app/cli/program_test.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr unsigned nobody = 65534;
constexpr int could_not_start = 127;
constexpr unsigned longest_run = 300;  // s; a program that hangs is ended by its alarm clock

void redirect(int descriptor, const fs::path& file, int flags) {
  const int opened = ::open(file.c_str(), flags, 0600);
  ::dup2(opened, descriptor);
  ::close(opened);
}

void settle_into(const Surroundings& around) {
  for (const auto& [name, value] : around.environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (around.largest_file > 0) {
    const rlimit limit{around.largest_file, around.largest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);
  }
  ::signal(SIGINT, SIG_DFL);
  ::alarm(longest_run);
  if (around.as_nobody && (::setgid(nobody) != 0 || ::setuid(nobody) != 0)) ::_exit(could_not_start);
}

[[noreturn]] void become_program(const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>("dougong")};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(DOUGONG_PROGRAM, words.data());
  ::_exit(could_not_start);
}

bool has_ended(pid_t child) {
  siginfo_t info = {};
  return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         info.si_pid != 0;
}

void signal_when_it_says(pid_t child, const Surroundings& around, const fs::path& out) {
  if (around.signal == 0) return;
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < limit && !has_ended(child)) {
    if (read_file(out).find(around.when_it_says) != std::string::npos) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ::kill(child, around.signal);
}

}  // namespace

Ran ProgramTest::run(const std::vector<std::string>& arguments, const Surroundings& around) const {
  const fs::path out = outputs_.path() / "out", err = outputs_.path() / "err";
  const int fresh = O_WRONLY | O_CREAT | O_TRUNC;
  write_file(out, "");
  const fs::path in = around.input.empty() ? "/dev/null" : outputs_.path() / "in";
  if (!around.input.empty()) write_file(in, around.input);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(folder().c_str()) != 0) ::_exit(could_not_start);
    redirect(STDIN_FILENO, in, O_RDONLY);
    redirect(STDOUT_FILENO, out, fresh);
    redirect(STDERR_FILENO, err, fresh);
    settle_into(around);
    become_program(arguments);
  }
  signal_when_it_says(child, around, out);
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
          read_file(out), read_file(err)};
}

fs::path ProgramTest::write(const std::string& name, const std::string& text) const {
  make_directory((folder() / name).parent_path());
  write_file(folder() / name, text);
  return folder() / name;
}

Surroundings ProgramTest::with_tool(const std::string& name, const std::string& script) const {
  const fs::path program = tools_.path() / name;
  write_file(program, "#!/bin/sh\n" + script);
  fs::permissions(program, fs::perms::owner_all);
  Surroundings around;
  around.environment["PATH"] = tools_.path().string() + ":/usr/bin:/bin";
  return around;
}

Surroundings ProgramTest::with_gnuplot(const std::string& script) const {
  return with_tool("gnuplot", script);
}

Surroundings ProgramTest::with_only(const std::string& name, const std::string& script) const {
  Surroundings around;
  around.environment["PATH"] = tools_.path().string();
  return script.empty() ? around : with_tool(name, script);
}

Surroundings ProgramTest::with_quick_plots() const {
  return with_gnuplot(
      "cat > /dev/null\n"
      "echo '<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\" height=\"1\"/>' > figure.svg\n"
      "echo > figure.png\n");
}

std::vector<std::string> ProgramTest::listing() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder()))
    names.push_back(fs::relative(entry.path(), folder()).string());
  std::ranges::sort(names);
  return names;
}

void ProgramTest::expect_refusal(const std::vector<std::string>& arguments,
                                 const std::vector<std::string>& words, const Surroundings& around) const {
  const auto before = listing();
  const Ran ran = run(arguments, around);
  EXPECT_EQ(ran.exit_code, 2) << ran.out << ran.err;
  for (const std::string& word : words) EXPECT_THAT(ran.err, testing::HasSubstr(word));
  EXPECT_THAT(ran.err, testing::StartsWith("dougong: "));
  EXPECT_EQ(listing(), before) << "a refused command must not leave anything behind";
}

std::vector<std::string> short_run(const std::string& out, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"run", "--set", "duration=1 s", "--out", out};
  if (std::ranges::find(more, "--record") == more.end())
    arguments.insert(arguments.end(), {"--record", "wenchuan"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace dougong::app
