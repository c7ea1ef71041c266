#pragma once

#include <QRect>
#include <QString>
#include <QStringList>

class QWidget;

namespace halbench::gui {

/// Without markup and access keys.
QString plain(const QString& text);

/// The words that a widget shows by itself; empty for those that show none.
QString textOf(const QWidget& widget);

/// Where they are, without frame, icon and mark.
QRect wordsPlace(const QWidget& widget);

/// Words, titles, tabs and headers that do not fit; a label that leaves words out on purpose has them in its
/// tooltip. One line each.
QStringList lackOfRoom(const QWidget& widget);

} // namespace halbench::gui
