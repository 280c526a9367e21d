#include "io/html.h"

#include "io/text.h"

namespace tidewater::io {

// "--" would end a comment.
std::string provenance_comment(const Provenance& provenance) {
    std::string text = "<!--\n";
    for (const auto& [name, value] : provenance_fields(provenance)) {
        std::string line = name + ": " + escape_xml(value);
        for (auto at = line.find("--"); at != line.npos; at = line.find("--", at)) line.replace(at, 2, "- -");
        text += line + "\n";
    }
    return text + "-->\n";
}

}  // namespace tidewater::io
