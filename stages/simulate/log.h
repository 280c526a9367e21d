// The run's log: lines to standard error and to <folder>/log, which gets its name when the run ends, well or
// not.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "core/files.h"

namespace tidewater {

class Log {
public:
    explicit Log(const std::filesystem::path& folder);
    void line(const std::string& text);
    void quiet_line(const std::string& text);  // to the file alone
    void finish();

private:
    PartFile part_;
    std::ofstream stream_;
};

}  // namespace tidewater
