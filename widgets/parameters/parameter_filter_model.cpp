#include "widgets/parameters/parameter_filter_model.h"

#include "widgets/parameters/parameter_table_model.h"

#include <algorithm>

namespace halbench::widgets {

ParameterFilterModel::ParameterFilterModel(QObject* parent) : QSortFilterProxyModel(parent) {
    setRecursiveFilteringEnabled(true);
}

void ParameterFilterModel::setSearch(const QString& words) {
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

void ParameterFilterModel::setChangedOnly(bool isChangedOnly) {
    m_isChangedOnly = isChangedOnly;
    invalidateFilter();
}

bool ParameterFilterModel::filterAcceptsRow(int row, const QModelIndex& parent) const {
    if (!parent.isValid()) {
        return false; // a group is there for its parameters
    }
    const QModelIndex cell = sourceModel()->index(row, ParameterTableModel::NameColumn, parent);
    if (m_isChangedOnly && !cell.data(ParameterTableModel::ChangedRole).toBool() &&
        !cell.data(ParameterTableModel::OutsideRole).toBool()) {
        return false;
    }
    const QString text = cell.data(ParameterTableModel::SearchRole).toString();
    return std::all_of(m_words.begin(), m_words.end(),
                       [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace halbench::widgets
