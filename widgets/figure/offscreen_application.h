#pragma once

#include "control/base/result.h"

#include <memory>

class QApplication;

namespace halbench::widgets {

/// Makes drawing possible in a headless program: uses the QApplication there is, or owns one on Qt's
/// offscreen platform for its own lifetime. Numbers stay in the C locale. Main thread only.
class OffscreenApplication {
public:
    /// Errors: Internal when a QCoreApplication without graphics exists; then nothing can be drawn.
    static Result<OffscreenApplication> ensure();
    OffscreenApplication(OffscreenApplication&& other) noexcept;
    ~OffscreenApplication();

private:
    explicit OffscreenApplication(std::unique_ptr<QApplication> owned);
    std::unique_ptr<QApplication> m_owned;
};

} // namespace halbench::widgets
