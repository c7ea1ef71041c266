#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QAction;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace halbench::widgets {
class MessageBar;
}

namespace halbench::app {

/// One row of a list of the start page.
struct StartEntry {
    QString path; ///< by which it is known
    QString title;
    QString detail;       ///< beside it, muted
    QString toolTip = {}; ///< the path, when empty
    QString fault = {};   ///< why it cannot be opened; empty: it can

    bool operator==(const StartEntry&) const = default;
};

/// A titled list of the start page, one tab stop. Double click and Enter open; a row that cannot be opened is
/// muted and says why. As tall as its rows: the page scrolls, not the list.
class StartList : public QWidget {
    Q_OBJECT

public:
    struct Words {
        QString title;
        QString empty; ///< in place of rows
        QString tip;
    };
    /// Rows of files can be removed from the list and shown in their folder, those of the program cannot.
    enum class Kind { Files, BuiltIn };

    StartList(const Words& words, Kind kind, QWidget* parent);

    void setEntries(std::vector<StartEntry> entries);
    const std::vector<StartEntry>& entries() const { return m_entries; }
    /// Below the rows, until another row is opened.
    void showError(const QString& text, const QString& remedy);

Q_SIGNALS:
    void shown(); ///< the rows may be old
    void openRequested(const QString& path);
    void removeRequested(const QString& path);

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildMenu(Kind kind);
    QAction& addMenuAction(const QString& text, void (StartList::*act)());
    void addRow(const StartEntry& entry);
    void fitRows();
    void refreshMenu();
    const StartEntry* current() const;
    void openCurrent();
    void removeCurrent();
    void openFolder();
    void copyPath();

    std::vector<StartEntry> m_entries;
    QTreeWidget* m_rows = nullptr;
    QLabel* m_empty = nullptr;
    widgets::MessageBar* m_message = nullptr;
    QAction* m_open = nullptr;
    QAction* m_folder = nullptr; ///< of Kind::Files
};

} // namespace halbench::app
