// What the cells of the parameter table say and look like.
#include "widgets/language/phrasebook.h"
#include "widgets/parameters/parameter_table_model.h"
#include "widgets/theme/icons.h"

namespace halbench::widgets {
namespace {

/// "kp" below the heading "gain": what the heading says needs no room in each row.
QString nameInGroup(const ParameterSpec& spec) {
    const std::string prefix = spec.group + '.';
    const bool isRepeated =
        spec.name.size() > prefix.size() && spec.name.compare(0, prefix.size(), prefix) == 0;
    return QString::fromStdString(isRepeated ? spec.name.substr(prefix.size()) : spec.name);
}

} // namespace

QString ParameterTableModel::shownValue(const Row& row, std::optional<double> value, Digits digits) const {
    if (!value) {
        return QStringLiteral("—");
    }
    const QStringList choices = choicesOf(row.spec);
    const int choice = static_cast<int>(*value);
    if (choice >= 0 && choice < choices.size() && *value == choice) {
        return choices.at(choice);
    }
    const double shown = *value * displayUnit(row.spec.unit, m_angleUnit).factor;
    constexpr int AllDigits = 7; // that a board's single-precision number has
    return digits == Digits::All ? numberText(shown, AllDigits) : settingText(shown);
}

QString ParameterTableModel::cellText(const Row& row, int column) const {
    switch (column) {
    case NameColumn:
        return nameInGroup(row.spec);
    case DeviceColumn:
        return shownValue(row, row.device, Digits::Few);
    case EditedColumn: // an edit is seen as it was typed
        return row.edited ? shownValue(row, row.edited) : shownValue(row, row.device, Digits::Few);
    case DefaultColumn:
        return shownValue(row, row.spec.defaultValue, Digits::Few);
    case UnitColumn:
        return displayUnit(row.spec.unit, m_angleUnit).text;
    case MinColumn:
        return choicesOf(row.spec).isEmpty() ? shownValue(row, row.spec.min, Digits::Few) : QString();
    case MaxColumn:
        return choicesOf(row.spec).isEmpty() ? shownValue(row, row.spec.max, Digits::Few) : QString();
    default:
        return {};
    }
}

QString ParameterTableModel::toolTip(const Row& row, int column) const {
    if (column == DeviceColumn && row.beforeOutsideChange) {
        return tr("Changed outside this window: %1 before, %2 now")
            .arg(shownValue(row, row.beforeOutsideChange), shownValue(row, row.device));
    }
    if (column == DeviceColumn && m_isStale) {
        return tr("Device disconnected; last reported value");
    }
    if (column == EditedColumn && row.edited) {
        return tr("Edited, not written yet; device value: %1").arg(shownValue(row, row.device));
    }
    if (column == EditedColumn && row.spec.access == ParameterAccess::ReadOnly) {
        return tr("Read-only value");
    }
    const QString help = inWords(row.spec.help);
    return column == NameColumn ? QString::fromStdString(row.spec.name) + QLatin1Char('\n') + help : help;
}

QVariant ParameterTableModel::look(const Row& row, int column, int role) const {
    const Theme theme = currentTheme();
    const bool isEdited = column == EditedColumn && row.edited;
    const bool isOutside = column == DeviceColumn && row.beforeOutsideChange;
    const bool isNumber = column != NameColumn && column != UnitColumn;
    switch (role) {
    case Qt::FontRole: {
        QFont font = isNumber ? tabularFont(QFont()) : QFont();
        font.setBold(isEdited || isOutside);
        font.setItalic(column == DeviceColumn && m_isStale);
        return font;
    }
    case Qt::ForegroundRole:
        if (isOutside) {
            return theme.warn;
        }
        if (isEdited) {
            return theme.accent;
        }
        return column == NameColumn ||
                       (column == EditedColumn && row.spec.access == ParameterAccess::ReadWrite)
                   ? QVariant(theme.text)
               : column == DeviceColumn && !m_isStale ? QVariant(theme.text)
                                                      : QVariant(theme.muted);
    case Qt::DecorationRole:
        if (isEdited) {
            return themedIcon(QStringLiteral("write"), Role::Primary);
        }
        return isOutside ? QVariant(themedIcon(QStringLiteral("warning"), Role::Warn)) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant(isNumber ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    default:
        return {};
    }
}

QVariant ParameterTableModel::groupData(const Group& group, int column, int role) const {
    if (column == NameColumn && (role == Qt::DisplayRole || role == Qt::AccessibleTextRole)) {
        return group.title;
    }
    if (role == Qt::FontRole) {
        QFont font;
        font.setBold(true);
        return font;
    }
    return {};
}

QVariant ParameterTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Row* row = rowAt(index);
    if (row == nullptr) {
        return groupData(m_groups[static_cast<std::size_t>(index.row())], index.column(), role);
    }
    switch (role) {
    case Qt::EditRole:
        if (index.column() == EditedColumn) {
            return shownValue(*row, row->edited ? row->edited : row->device);
        }
        return cellText(*row, index.column());
    case Qt::DisplayRole:
        return cellText(*row, index.column());
    case Qt::ToolTipRole:
        return toolTip(*row, index.column());
    case Qt::AccessibleTextRole:
        return tr("%1, %2: %3")
            .arg(QString::fromStdString(row->spec.name),
                 headerData(index.column(), Qt::Horizontal, role).toString(), cellText(*row, index.column()));
    case Qt::AccessibleDescriptionRole:
        return toolTip(*row, index.column());
    case NameRole:
        return QString::fromStdString(row->spec.name);
    case ChangedRole:
        return row->edited.has_value();
    case OutsideRole:
        return row->beforeOutsideChange.has_value();
    case SearchRole:
        return QString::fromStdString(row->spec.name + ' ' + row->spec.group + ' ' + row->spec.help + ' ' +
                                      row->spec.unit);
    case ChoicesRole:
        return choicesOf(row->spec);
    default:
        return look(*row, index.column(), role);
    }
}

QVariant ParameterTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        const bool isNumber = section != NameColumn && section != UnitColumn;
        return QVariant(isNumber ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) {
        return {};
    }
    const QStringList words = {tr("Parameter"), tr("Device"),  tr("Edited"), tr("Unit"),
                               tr("Default"),   tr("Minimum"), tr("Maximum")};
    return words.value(section);
}

} // namespace halbench::widgets
