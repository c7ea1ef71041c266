#pragma once

#include "app/window/docks/perspective.h"

#include <QWidget>

class QActionGroup;
class QToolButton;

namespace halbench::app {

/// Chooses the perspective: a button each, or, where there is no room, one button with a menu. The keys are
/// the same.
class PerspectiveBar : public QWidget {
    Q_OBJECT

public:
    explicit PerspectiveBar(QWidget* parent = nullptr);

    void setPerspective(Perspective perspective);
    /// One that the open device has no use for has neither button nor key.
    void setOffered(Perspective perspective, bool isOffered);
    void setCollapsed(bool isCollapsed);
    /// What collapsing saves.
    int saved_px() const;

Q_SIGNALS:
    void chosen(halbench::app::Perspective perspective);

private:
    void addChoice(Perspective perspective);
    void sayWords();

    QActionGroup* m_choices = nullptr;
    QWidget* m_buttons = nullptr;
    QToolButton* m_menu = nullptr;
};

} // namespace halbench::app
