#pragma once

#include "app/workbench/drive_control.h"
#include "app/workspaces/parts/focus_keeper.h"
#include "widgets/controls/message_bar.h"

#include <QPushButton>

namespace halbench::app {

/// What is said before a real actuator is armed for the first time; the action arms it.
widgets::Message armingWarning();

/// Arms, or disarms what is armed. A real actuator is armed only after consent, which its place asks for.
class ArmButton : public QPushButton {
    Q_OBJECT

public:
    /// Of a window one has the key Ctrl+Shift+A: a press is one click, however long it is held.
    enum class Key { Has, IsToldOnly };
    ArmButton(DriveControl& control, Key key, QWidget* parent);

    /// Room for either word: nothing beside it moves when it changes.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void consentNeeded();

protected:
    void changeEvent(QEvent* event) override;
    /// The second click of a double click on Disarm must not arm again.
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    void onClicked();
    void refresh();
    void sayWords();
    void dress();

    DriveControl& m_control;
    FocusKeeper m_rest; ///< its parent
};

} // namespace halbench::app
