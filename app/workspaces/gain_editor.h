#pragma once

#include "app/procedures/tune.h"
#include "widgets/display_units.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// The gains of the position law (parallel form) in A/rad or A/deg, the feed-forward and the friction assist
/// behind a button. What is no number never leaves it.
class GainEditor : public QWidget {
    Q_OBJECT
public:
    explicit GainEditor(QWidget* parent = nullptr);

    /// The preferred one; who chooses another here has it until the preference changes.
    void setAngleUnit(widgets::AngleUnit unit);
    void setLaw(const control::PositionLaw& law);
    /// Errors: InvalidInput naming the field; of lawFromParameters.
    Result<control::PositionLaw> law() const;

Q_SIGNALS:
    void edited(); ///< by the user

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QLabel* name;
        widgets::OptionalNumberEdit* edit;
        QLabel* unit;
        ParameterValue value; ///< SI
        bool isExtra;
    };
    void addRow(const ParameterValue& value, bool isExtra);
    void refreshWords();
    void refreshNumbers();
    void showExtras(bool isShown);
    widgets::DisplayUnit unitOf(const Row& row) const;

    std::vector<Row> m_rows;
    QGridLayout* m_grid = nullptr;
    QLabel* m_form = nullptr;
    QComboBox* m_unit = nullptr;
    QToolButton* m_extras = nullptr;
};

} // namespace halbench::app
