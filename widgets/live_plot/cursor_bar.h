#pragma once

#include "widgets/live_plot/cursor_pairs.h"
#include "widgets/theme/theme.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QAction;
class QLabel;
class QLineEdit;
class QMenu;
class QToolButton;

namespace halbench::widgets {

class TimeField;

/// The pair that measures: its name, under which a menu has the other pairs, its cursors' times, which can be
/// typed, their distance and its reciprocal.
class CursorBar : public QWidget {
    Q_OBJECT
public:
    explicit CursorBar(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /// What can be done with pairs, for the menu.
    void setPairActions(const QList<QAction*>& actions);
    void setPairs(const CursorPairs& pairs);
    /// The stretch that is shown and the samples' period: what decimals are worth showing.
    void setResolution(double span_s, std::optional<double> period_s);
    /// The next keys are the name.
    void editName();
    /// Stays until something else is shown; beside the distance.
    void refuseName(const QString& reason);
    /// "Δt 0.125 s   1/Δt 8 Hz"
    QString distanceText() const;

Q_SIGNALS:
    void cursorTyped(int index, double time_s);
    void pairChosen(int pair);
    void nameTyped(const QString& name);

private:
    void addPairFields();
    void fillMenu();
    void finishName();
    void addTimeField(int index);
    void showTimes(const CursorPair& cursors);

    QToolButton* m_menu;
    QLineEdit* m_name;
    TimeField* m_fields[2];
    QLabel* m_distance;
    QLabel* m_refusal;
    CursorPairs m_pairs;
    int m_decimals = 4;
    QList<QAction*> m_actions;
    QMenu* m_list;
    QPointer<QWidget> m_before; ///< had the focus before the name
};

} // namespace halbench::widgets
