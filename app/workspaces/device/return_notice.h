#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace halbench::widgets {
class MessageBar;
struct Message;
} // namespace halbench::widgets

namespace halbench::app {

/// What became of a device that was lost: that it is looked for and why it is not back yet; then that it is,
/// and which settings differ from before, to be written back or accepted. A strip of the window, seen in
/// every perspective; never a box.
class ReturnNotice : public QWidget {
    Q_OBJECT

public:
    explicit ReturnNotice(Workbench& bench, QWidget* parent = nullptr);

private:
    void buildDifferences();
    void onState();
    void refreshWrite();
    void showSearch();
    void showReturn();
    void endWhenArmed();
    void showDifferences();
    void writeBack();
    void leaveFocus();
    void say(const widgets::Message& message);

    Workbench& m_bench;
    bool m_hasDiffered = false; ///< since the last loss
    QString m_decision;         ///< on what differed, when it was made here
    widgets::MessageBar* m_message = nullptr;
    QWidget* m_differences = nullptr;
    QLabel* m_list = nullptr;
    QPushButton* m_write = nullptr;
    QPushButton* m_accept = nullptr;
};

} // namespace halbench::app
