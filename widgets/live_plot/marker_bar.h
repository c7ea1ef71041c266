#pragma once

#include "widgets/live_plot/plot_marker.h"
#include "widgets/theme/theme.h"

#include <QPointer>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QMenu;
class QToolButton;

namespace halbench::widgets {

/// The chosen marker: a menu with all of them, its moment, its note, which can be typed.
class MarkerBar : public QWidget {
    Q_OBJECT
public:
    explicit MarkerBar(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /// What can be done with markers, for the menu; `remove` has a button too.
    void setActions(const QList<QAction*>& actions, QAction& remove);
    void setMarkers(const std::vector<PlotMarker>& markers, std::optional<std::size_t> chosen, double span_s);
    /// The next keys are the note.
    void editNote();
    /// The list of all markers as a menu.
    void showList();

Q_SIGNALS:
    void markerChosen(int marker);
    void noteTyped(const QString& note); ///< Enter, or the focus went elsewhere
    void accepted();                     ///< Enter, and the row is done with
    void cancelled();                    ///< Escape: the note is as it was

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fillMenu();
    void noteKey(int key);
    void finishNote();
    void giveFocusBack();

    QToolButton* m_menu;
    QMenu* m_list;
    QLabel* m_time;
    QLineEdit* m_note;
    QToolButton* m_remove;
    QToolButton* m_close;
    std::vector<PlotMarker> m_markers;
    std::optional<std::size_t> m_chosen;
    double m_span_s = 1.0;
    QList<QAction*> m_actions;
    QPointer<QWidget> m_before; ///< had the focus before the note
};

} // namespace halbench::widgets
