// The style and the script of report.h's page.
#pragma once

namespace tidewater::io {

extern const char* const report_style;   // CSS
extern const char* const report_script;  // a <script> element, to stand at the end of the page

}  // namespace tidewater::io
