#pragma once

#include "control/design/crossover_design.h"

#include <QWidget>

#include <optional>

class QAction;
class QLabel;
class QSlider;

namespace halbench::app {

/// How fast and how robust the loop is, as two sliders: its gain crossover and its phase margin. Says in
/// words where both cannot be had. Only shows and asks. Thread: GUI.
class LoopSliders : public QWidget {
    Q_OBJECT
public:
    explicit LoopSliders(QWidget* parent = nullptr);

    /// What the loop has; nothing: there is none, or it does not cross. A slider in the hand stays.
    void setLoop(const std::optional<control::CrossoverAim>& aim, const control::LoopTiming& timing);
    /// Why the loop is not what was asked; CrossoverLimit::None says nothing any more.
    void sayLimit(const control::CrossoverAim& wanted, const control::CrossoverDesign& design);
    void sayProblem(const QString& text);
    /// Their buttons stand beside the sliders.
    void setHistory(QAction& undo, QAction& redo);

Q_SIGNALS:
    void taken();
    void released();
    void crossoverMoved(double crossover_rad_s); ///< between taken() and released(), or by itself
    void phaseMarginMoved(double phaseMargin_deg);

protected:
    void changeEvent(QEvent* event) override;

private:
    QSlider* addSlider(QLabel*& name, QLabel*& number, int line);
    void refreshWords();
    void showNumbers();
    double crossoverAt(int place) const;
    int placeOf(double crossover_rad_s) const;

    control::LoopTiming m_timing;
    std::optional<control::CrossoverAim> m_aim;
    QLabel* m_speedName = nullptr;
    QLabel* m_speedNumber = nullptr;
    QSlider* m_speed = nullptr;
    QLabel* m_marginName = nullptr;
    QLabel* m_marginNumber = nullptr;
    QSlider* m_margin = nullptr;
    QLabel* m_note = nullptr;
};

} // namespace halbench::app
