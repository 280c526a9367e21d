// A film of pictures by ffmpeg, a program that need not be there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tidewater::io {

// The first executable file of this name in a folder of the environment's PATH.
std::optional<std::filesystem::path> find_on_path(const std::string& program);

// Pictures a second: as fast as the time between them passes, but from 4 to 30; `times` (s) rise.
double movie_rate(const std::vector<double>& times);

// Replaces path as a whole by an MP4 (H.264, yuv420p, which every player takes) of the PNG pictures one after
// the other, `rate` a second. Odd sizes get a white row or column. ffmpeg is run without a shell; what it
// complains about goes to standard error. Throws OutputError if it fails. pictures: at least one, all of one
// size.
void write_movie(const std::filesystem::path& ffmpeg, const std::vector<std::filesystem::path>& pictures,
                 double rate, const std::filesystem::path& path);

}  // namespace tidewater::io
