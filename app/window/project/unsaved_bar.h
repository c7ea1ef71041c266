#pragma once

#include "control/base/result.h"

#include <QWidget>

class QPushButton;

namespace halbench::widgets {
class MessageBar;
}

namespace halbench::app {

/// Said where a project cannot be left because what it holds could not be written: it stays open, and the
/// user has the choice. Thread: GUI.
class UnsavedBar : public QWidget {
    Q_OBJECT

public:
    explicit UnsavedBar(QWidget* parent = nullptr);

    void showError(const Error& error);

Q_SIGNALS:
    void tryAgainRequested();
    void saveAsRequested();
    void discardRequested();
    void stayRequested(); ///< dismissed: nothing waits any more

protected:
    void changeEvent(QEvent* event) override;

private:
    void refreshWords();

    widgets::MessageBar* m_message = nullptr;
    QPushButton* m_again = nullptr;
    QPushButton* m_saveAs = nullptr;
    QPushButton* m_discard = nullptr;
};

} // namespace halbench::app
