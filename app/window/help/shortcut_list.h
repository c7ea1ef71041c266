#pragma once

#include <QDialog>
#include <QString>

#include <vector>

class QAbstractButton;
class QAction;
class QLineEdit;
class QTableWidget;

namespace halbench::app {

/// One key of the window.
struct ShortcutRow {
    QString keys;
    QString function;
    QString place; ///< title of the panel that it works in; of the window: "Window"

    bool operator==(const ShortcutRow&) const = default;
};

/// The keys of these actions, by function; an action without a key or a text has none.
std::vector<ShortcutRow> shortcutRows(const QList<QAction*>& actions, const QString& place);
/// The same of buttons. The letter that is underlined in a text is no key of the list.
std::vector<ShortcutRow> shortcutRows(const QList<QAbstractButton*>& buttons, const QString& place);

/// All keys of the window, searched by key, function or panel. They are those of the actions themselves.
/// Carries a small STOP.
class ShortcutList : public QDialog {
    Q_OBJECT

public:
    explicit ShortcutList(const std::vector<ShortcutRow>& rows, QWidget* parent = nullptr);

Q_SIGNALS:
    void stopRequested();

private:
    void fill(const std::vector<ShortcutRow>& rows);
    void filter(const QString& text);

    QLineEdit* m_search = nullptr;
    QTableWidget* m_table = nullptr;
};

} // namespace halbench::app
