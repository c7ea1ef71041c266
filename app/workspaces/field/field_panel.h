#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QButtonGroup;
class QLabel;

namespace halbench::widgets {
class RotorView;
}

namespace halbench::app {

/// The rotor's cross-section turning live, with the field as designed, as built or as measured
/// (resources/help/monitor.md, "Field").
class FieldPanel : public QWidget {
    Q_OBJECT

public:
    explicit FieldPanel(Workbench& bench, QWidget* parent = nullptr);

private:
    QWidget* buildToggles();
    void onDevice();
    void onSamples();
    double latest(const char* role) const;

    Workbench& m_bench;
    widgets::RotorView* m_view = nullptr;
    QButtonGroup* m_models = nullptr;
    QLabel* m_words = nullptr;
};

} // namespace halbench::app
