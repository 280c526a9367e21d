#include "io/movie.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <sstream>

#include "core/error.h"
#include "core/files.h"
#include "io/text.h"

extern char** environ;

namespace tidewater::io {
namespace {

// Its exit code; 128 + the signal that ended it, 127 if it cannot be started.
int run_program(std::vector<std::string> words) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    if (posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return 127;
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return 127;
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// For ffmpeg's concat reader, in which a quote ends the quoted text.
std::string list_line(const std::filesystem::path& picture) {
    std::string line = "file 'file:";
    for (const char letter : std::filesystem::absolute(picture).string())
        line += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return line + "'\n";
}

}  // namespace

std::optional<std::filesystem::path> find_on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const auto file = std::filesystem::path(folder.empty() ? "." : folder) / program;
        std::error_code error;
        if (std::filesystem::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0) return file;
    }
    return std::nullopt;
}

double movie_rate(const std::vector<double>& times) {
    constexpr double slowest = 4.0, fastest = 30.0;
    if (times.size() < 2 || !(times.back() > times.front())) return slowest;
    const double rate = static_cast<double>(times.size() - 1) / (times.back() - times.front());
    return std::clamp(rate, slowest, fastest);
}

void write_movie(const std::filesystem::path& ffmpeg, const std::vector<std::filesystem::path>& pictures,
                 double rate, const std::filesystem::path& path) {
    assert(!pictures.empty() && rate > 0.0);
    std::string list;
    for (const auto& picture : pictures) list += list_line(picture);
    PartFile list_file(path.string() + ".list");  // not committed, and so removed
    PartFile movie(path);
    write_text(list_file.part_path(), list);
    const std::string rate_text = format_fixed(rate, 3);
    const int code = run_program({ffmpeg.string(),
                                  "-nostdin",
                                  "-hide_banner",
                                  "-loglevel",
                                  "error",
                                  "-y",
                                  "-f",
                                  "concat",
                                  "-safe",
                                  "0",
                                  "-r",
                                  rate_text,
                                  "-i",
                                  list_file.part_path().string(),
                                  "-vf",
                                  "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white",
                                  "-c:v",
                                  "libx264",
                                  "-crf",
                                  "18",
                                  "-pix_fmt",
                                  "yuv420p",
                                  "-movflags",
                                  "+faststart",
                                  "-threads",
                                  "1",
                                  "-fflags",
                                  "+bitexact",
                                  "-f",
                                  "mp4",
                                  movie.part_path().string()});
    if (code != 0) {
        throw OutputError(path.string() + ": " + ffmpeg.string() + " failed with exit code " +
                          std::to_string(code) + "; run again without --movie or mend ffmpeg");
    }
    movie.commit();
}

}  // namespace tidewater::io
