#pragma once

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

/// Runs the built program and keeps what it says.
namespace percuss::test {

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

struct Outcome {
    int status = -1;  ///< exit status, or 128 + signal
    std::string out, err;
};

/// A run of build/percuss in a folder, without a display.
class Program {
  public:
    Program(const std::filesystem::path& folder, std::vector<std::string> arguments) : folder_(folder) {
        const std::string program = std::filesystem::path(PERCUSS_BINARY_DIR) / "percuss";
        arguments.insert(arguments.begin(), program);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        const std::string out = folder_ / ".stdout", err = folder_ / ".stderr";
        process_ = fork();
        if (process_ != 0) return;
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        const bool ready = chdir(folder_.c_str()) == 0 &&
                           dup2(open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 1) >= 0 &&
                           dup2(open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), 2) >= 0;
        if (ready) execv(program.c_str(), argv.data());
        _exit(127);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() {
        if (process_ > 0) send(SIGKILL), static_cast<void>(wait());
    }

    void send(int signal) const { kill(process_, signal); }

    [[nodiscard]] Outcome wait() {
        int status = 0;
        waitpid(process_, &status, 0);
        process_ = -1;
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                text_of(folder_ / ".stdout"), text_of(folder_ / ".stderr")};
    }

  private:
    std::filesystem::path folder_;
    pid_t process_ = -1;
};

inline Outcome percuss(const std::filesystem::path& folder, std::vector<std::string> arguments) {
    return Program(folder, std::move(arguments)).wait();
}

}  // namespace percuss::test
