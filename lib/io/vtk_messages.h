// What VTK would print, kept instead, so that our one-line errors replace it.
#pragma once

#include <string>

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace tidewater::io {

class VtkMessages : public vtkOutputWindow {
public:
    static VtkMessages* New();
    vtkTypeMacro(VtkMessages, vtkOutputWindow);

    void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override { keep(text); }
    void DisplayWarningText(const char*) override {}
    // Among them is what the legacy readers say of data that end too early.
    void DisplayGenericWarningText(const char* text) override { keep(text); }
    void DisplayDebugText(const char*) override {}

    // Empty where there was none.
    const std::string& first_error() const { return first_error_; }

private:
    void keep(const char* text) {
        if (first_error_.empty()) first_error_ = text;
    }

    std::string first_error_;
};

// While it lives, VTK prints nothing. Not nested, and of one thread at a time.
class QuietVtk {
public:
    QuietVtk() : before_(vtkOutputWindow::GetInstance()), messages_(vtkSmartPointer<VtkMessages>::New()) {
        vtkOutputWindow::SetInstance(messages_);
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    }
    ~QuietVtk() {
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);  // VTK's default
        vtkOutputWindow::SetInstance(before_);
    }
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

    bool failed() const { return !messages_->first_error().empty(); }
    const std::string& first_error() const { return messages_->first_error(); }

private:
    vtkSmartPointer<vtkOutputWindow> before_;
    vtkSmartPointer<VtkMessages> messages_;
};

}  // namespace tidewater::io
