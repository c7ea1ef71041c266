#pragma once

#include <functional>

class QWidget;

namespace halbench::widgets {

/// Calls `say` now and whenever the language changes, as long as the widget lives: for words that are set
/// once and change with nothing else.
void sayWords(QWidget& widget, std::function<void()> say);

} // namespace halbench::widgets
