#pragma once

#include "app/procedures/tune/position_law_parameters.h"
#include "app/workbench/display_quantity.h"
#include "control/law/filtered_law.h"

#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// Set-point weights, filter on the derivative and filters in series around the gains; whether the connected
/// device runs them stands above. Behind a button while there is none. Gives finite numbers only.
/// Thread: GUI.
class FilterEditor : public QWidget {
    Q_OBJECT
public:
    explicit FilterEditor(QWidget* parent = nullptr);

    void setFrequencyUnit(FrequencyUnit unit);
    /// Weights and filters of the connected device's law; nothing: no device is connected.
    void setOffered(const std::optional<BoardLawSpec>& offered);
    /// Of a law, whose gains are not read; nothing: the board's own.
    void setShaping(const std::optional<control::FilteredLaw>& filtered);
    /// These gains with what stands here around them; nothing when the board's law is all of it. Errors:
    /// InvalidInput naming the field.
    Result<std::optional<control::FilteredLaw>> filtered(const control::PidGains& gains) const;

Q_SIGNALS:
    /// By the user: "Edit Filter 1: Corner"; `isTyped`: one of many strokes.
    void edited(const QString& what, bool isTyped);
    void fieldAdded(QWidget* field);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Field {
        QLabel* name = nullptr;
        widgets::OptionalNumberEdit* edit = nullptr;
        QLabel* unit = nullptr;
    };
    struct Filter {
        QWidget* box = nullptr;
        QComboBox* kind = nullptr;
        QToolButton* remove = nullptr;
        QGridLayout* grid = nullptr;
        std::vector<Field> fields;
        control::LoopFilter filter;
    };

    Field addField(QGridLayout& grid, int line);
    void addFilter(const control::LoopFilter& filter);
    void removeFilter(QWidget* box);
    void dropFilter(std::size_t at);
    void buildFields(Filter& row);
    void chooseKind(QWidget* box, int kind);
    void takeFigure(QWidget* box, std::size_t figure);
    Filter* rowOf(const QWidget* box);
    void showFigures(Filter& row);
    void showAll();
    void sayWords();
    void sayOffered();
    void sayFilter(std::size_t at);
    void expand(bool isShown);
    void bringIntoSight();
    double factorOf(const control::LoopFilter& filter, std::size_t figure) const;

    FrequencyUnit m_unit = FrequencyUnit::Hertz;
    std::optional<BoardLawSpec> m_offered;
    control::FilteredLaw m_shaping; ///< its gains but for the filter, and its filters, do not count
    std::vector<Filter> m_rows;
    QToolButton* m_toggle = nullptr;
    QWidget* m_body = nullptr;
    QLabel* m_note = nullptr;
    Field m_b;
    Field m_c;
    Field m_time;
    QVBoxLayout* m_list = nullptr;
    QPushButton* m_add = nullptr;
};

} // namespace halbench::app
