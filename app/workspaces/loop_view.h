#pragma once

#include "app/report/tuning_figures.h"

#include <QWidget>

#include <array>

class QComboBox;
class QLabel;

namespace halbench::widgets {
class FigureView;
} // namespace halbench::widgets

namespace halbench::app {

/// The open loop as the user wants to see it: Bode, Nyquist, Nichols, its sensitivity or its root locus.
class LoopView : public QWidget {
    Q_OBJECT
public:
    enum class View { Bode, Nyquist, Nichols, Sensitivity, RootLocus };

    explicit LoopView(QWidget* parent = nullptr);

    void setLoops(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                  const std::vector<NamedLoop>& others,
                  const std::optional<MeasuredLoop>& measured = std::nullopt); ///< in the Bode plot alone
    void setView(View view);
    widgets::FigureView& picture() { return *m_picture; }

protected:
    void changeEvent(QEvent* event) override;

private:
    static constexpr std::size_t Views = 5;
    void sayWords();
    void show(int view);

    std::array<widgets::Figure, Views> m_figures;
    QLabel* m_label = nullptr;
    QComboBox* m_choice = nullptr;
    widgets::FigureView* m_picture = nullptr;
    QLabel* m_note = nullptr; ///< why a picture is missing
};

} // namespace halbench::app
