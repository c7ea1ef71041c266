#pragma once

#include "widgets/theme/theme_style.h"

#include <QString>

class QBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace halbench::widgets {
class QuantityEdit;
}

namespace halbench::app {

/// A number field as the panels use it: what it is for, its unit and how finely it steps.
struct NumberField {
    QString name;      ///< accessible name
    QString toolTip;   ///< with its shortcut if it has one
    QString unit = {}; ///< as shown
    int decimals = 2;
    double min = 0.0;
    double max = 1.0;
    double step = 1.0;
};

widgets::QuantityEdit* makeNumberField(const NumberField& field, QWidget* parent);
void dressNumberField(widgets::QuantityEdit& box, const NumberField& field);

struct PushAction {
    QString text;
    QString toolTip;
    QString icon; ///< of widgets/theme/icons.h; empty: none
};
QPushButton* makeButton(const PushAction& action, QWidget* parent);

/// The vertical layout of a panel with its margins.
QVBoxLayout* makePanelColumn(QWidget* panel);

/// The same for a panel that may be taller than its place: it scrolls up and down, never sideways.
QVBoxLayout* makeScrollingColumn(QWidget* panel);

/// Scrolls a part that may be taller than its place, without a frame; the focus stays with its controls.
QScrollArea* makeScrollArea(QWidget* content);

/// A titled part of a panel; returns the layout to fill.
QVBoxLayout* addSection(QBoxLayout* column, const QString& title, QWidget* parent);

/// setRole() for words that change often: does nothing when the role stays.
void showRole(QWidget& widget, widgets::Role role);

/// A small label in muted words that wraps.
QLabel* makeNote(QWidget* parent);
/// Keeps the place of so many lines, so that longer words move nothing below them.
void reserveLines(QLabel& note, int lines);

} // namespace halbench::app
