#pragma once

#include "widgets/rotor_view.h"

#include <QWidget>

#include <array>

class QButtonGroup;
class QPushButton;

namespace halbench::widgets {

/// The rotor's cross-section with the choice of what its field lines are.
class RotorPanel : public QWidget {
    Q_OBJECT
public:
    explicit RotorPanel(QWidget* parent = nullptr);

    RotorView& view() { return *m_view; }
    void setFieldModel(FieldModel model);

Q_SIGNALS:
    void fieldModelChanged(halbench::widgets::FieldModel model); ///< by the user

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    RotorView* m_view = nullptr;
    QButtonGroup* m_group = nullptr;
    std::array<QPushButton*, 3> m_buttons{};
};

} // namespace halbench::widgets
