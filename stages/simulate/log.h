// The run's log: lines to standard error and to <folder>/log, which gets its name when the run ends, well or
// not. A run that goes on from a checkpoint goes on with the log too.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "core/files.h"

namespace tidewater {

class Log {
public:
    Log(const std::filesystem::path& folder, bool go_on);
    void line(const std::string& text);
    void quiet_line(const std::string& text);  // to the file alone
    void finish();

private:
    std::string earlier_;  // read before the part is begun anew
    PartFile part_;
    std::ofstream stream_;
};

}  // namespace tidewater
