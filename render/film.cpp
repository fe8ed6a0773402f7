#include "film.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace percuss::render {

namespace {

/// Keeps SIGPIPE from ending the program while this thread writes to a process that may have died; the write
/// then fails with EPIPE instead.
class BlockedSigpipe {
  public:
    BlockedSigpipe() {
        sigemptyset(&sigpipe_);
        sigaddset(&sigpipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &sigpipe_, &before_);
    }
    ~BlockedSigpipe() {
        const timespec none{0, 0};
        while (sigtimedwait(&sigpipe_, nullptr, &none) == SIGPIPE) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    BlockedSigpipe(const BlockedSigpipe&) = delete;
    BlockedSigpipe& operator=(const BlockedSigpipe&) = delete;

  private:
    sigset_t sigpipe_{}, before_{};
};

std::string last_lines(const std::string& text) {
    constexpr std::size_t longest = 600;
    std::string tail = text.size() > longest ? text.substr(text.size() - longest) : text;
    while (!tail.empty() && tail.back() == '\n') tail.pop_back();
    return tail;
}

}  // namespace

struct Film::Impl {
    std::filesystem::path file;
    int width = 0, height = 0;
    pid_t process = -1;
    int input = -1;   // we write pictures
    int errors = -1;  // we read ffmpeg's words
    std::string words;

    void start(const std::vector<std::string>& arguments);
    void read_errors();
    /// Waits; returns true when ffmpeg ended well.
    bool wait();
    [[noreturn]] void fail() {
        wait();
        throw RenderError(fmt::format("{}: ffmpeg failed: {}", file.string(),
                                      words.empty() ? "without a message" : last_lines(words)));
    }
};

void Film::Impl::start(const std::vector<std::string>& arguments) {
    std::array<int, 2> to{}, from{};
    if (pipe2(to.data(), O_CLOEXEC) != 0)
        throw RenderError(fmt::format("cannot make a pipe to ffmpeg: {}", std::strerror(errno)));
    if (pipe2(from.data(), O_CLOEXEC) != 0) {
        close(to[0]);
        close(to[1]);
        throw RenderError(fmt::format("cannot make a pipe to ffmpeg: {}", std::strerror(errno)));
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, from[1], STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const int result = posix_spawnp(&process, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(to[0]);
    close(from[1]);
    input = to[1];
    errors = from[0];
    if (result == 0) {
        fcntl(errors, F_SETFL, O_NONBLOCK);
        return;
    }
    process = -1;
    close(input);
    close(errors);
    input = errors = -1;
    if (result == ENOENT)
        throw RenderError("ffmpeg not found; install the package ffmpeg, or leave out --film");
    throw RenderError(fmt::format("ffmpeg cannot be started: {}", std::strerror(result)));
}

void Film::Impl::read_errors() {
    std::array<char, 4096> buffer{};
    for (ssize_t count = 0; (count = read(errors, buffer.data(), buffer.size())) > 0;)
        words.append(buffer.data(), static_cast<std::size_t>(count));
}

bool Film::Impl::wait() {
    if (input >= 0) close(input);
    input = -1;
    if (process < 0) return false;
    fcntl(errors, F_SETFL, 0);  // until its end of file: ffmpeg must not block on a full pipe
    read_errors();
    close(errors);
    errors = -1;
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    process = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Film::Film(const std::filesystem::path& file, int width, int height, double frames_per_second)
    : impl_(std::make_unique<Impl>()) {
    if (width < 1 || height < 1 || !(frames_per_second > 0))
        throw RenderError("a film needs pictures of at least one pixel and a positive frame rate");
    impl_->file = file;
    impl_->width = width;
    impl_->height = height;
    // yuv420p halves the colour planes, so odd sides are filled up with white.
    impl_->start({"ffmpeg",
                  "-hide_banner",
                  "-loglevel",
                  "error",
                  "-y",
                  "-f",
                  "rawvideo",
                  "-pix_fmt",
                  "rgb24",
                  "-s",
                  fmt::format("{}x{}", width, height),
                  "-r",
                  fmt::format("{}", frames_per_second),
                  "-i",
                  "-",
                  "-vf",
                  "pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:white",
                  "-c:v",
                  "libx264",
                  "-preset",
                  "veryfast",
                  "-crf",
                  "18",
                  "-pix_fmt",
                  "yuv420p",
                  "-movflags",
                  "+faststart",
                  "-f",
                  "mp4",
                  "file:" + std::filesystem::absolute(file).string()});
}

Film::~Film() { impl_->wait(); }

void Film::add(const Image& image) {
    if (image.width != impl_->width || image.height != impl_->height)
        throw RenderError(fmt::format("{}: a picture of {} x {} pixels in a film of {} x {}",
                                      impl_->file.string(), image.width, image.height, impl_->width,
                                      impl_->height));
    if (impl_->input < 0) throw RenderError(fmt::format("{}: the film is finished", impl_->file.string()));
    const BlockedSigpipe blocked;
    for (std::size_t done = 0; done < image.pixels.size();) {
        const ssize_t count = write(impl_->input, image.pixels.data() + done, image.pixels.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) impl_->fail();
        done += static_cast<std::size_t>(count);
        impl_->read_errors();
    }
}

void Film::finish() {
    if (impl_->process >= 0 && !impl_->wait()) impl_->fail();
}

}  // namespace percuss::render
