#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace halbench::app {

/// How fast simulated time runs. A real device has its own time: then it is disabled, or hidden.
class PaceRow : public QWidget {
    Q_OBJECT

public:
    enum class Place { Devices, BesideStart };
    PaceRow(Workbench& bench, Place place, QWidget* parent);

private:
    void sayWords();
    void refresh();
    void showPace();

    Workbench& m_bench;
    Place m_place;
    QLabel* m_label = nullptr;
    QComboBox* m_box = nullptr;
};

} // namespace halbench::app
