#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace percuss::app {

/// A program started without a shell, its input empty, its output and errors in a file. It is ended and
/// awaited when this goes.
class ChildProcess {
  public:
    /// @param program path, or a name that is looked for in PATH. @throws std::runtime_error when it cannot
    /// be started.
    ChildProcess(const std::string& program, const std::vector<std::string>& arguments,
                 const std::filesystem::path& output);
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Its exit status, 128 + signal when one ended it; nothing while it runs.
    [[nodiscard]] std::optional<int> ended();
    void end();  ///< SIGTERM, and waits

  private:
    pid_t id_ = -1;
    int status_ = 0;
};

/// The program that runs now.
[[nodiscard]] std::filesystem::path own_program();

}  // namespace percuss::app
