#pragma once

#include <QHash>
#include <QStringList>

class QMenu;
class QWidget;

namespace halbench::gui {

/// Every English text of a translation file that reads differently in that language; of a message into which
/// something is filled its longest part. Empty for English.
QHash<QString, QString> phrasesOf(const QString& language);

/// What a picky user would find in the visible widgets below `root`: words wider than their widget, controls
/// without a name or a tooltip, English words in another language, contrast under 4.5; those of tabs,
/// columns, cells and empty fields (seen_text.h) among them. One line each, with the widget's path.
QStringList inspect(const QWidget& root, const QHash<QString, QString>& phrases);

/// Access keys that a menu has twice, and English words in it.
QStringList inspectMenu(const QMenu& menu, const QHash<QString, QString>& phrases);

/// Keys that two of the visible controls, menu titles and actions of a window share: neither would work then.
QStringList inspectKeys(const QWidget& window);

} // namespace halbench::gui
