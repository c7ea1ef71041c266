#pragma once

#include <QRect>
#include <QString>

#include <vector>

class QWidget;

namespace halbench::gui {

struct SeenWords {
    QString text;
    QRect place; ///< in the widget
};

/// Words that a widget paints part by part: titles of tabs and columns, what a field shows or asks for while
/// it is empty, the first rows of a view's cells. Only what is in sight and not disabled.
std::vector<SeenWords> seenWords(const QWidget& widget);

} // namespace halbench::gui
