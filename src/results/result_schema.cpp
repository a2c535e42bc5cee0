// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/document_parts.hpp"
#include "results/identification_parts.hpp"

namespace taut {
namespace {

std::string schema_of_documents() {
    ResultJson documents = ResultJson::array();
    ResultJson definitions = ResultJson::object();
    for (const Rule& rule :
         {description_of<Study>().rule(), description_of<Identification>().rule(),
          description_of<Comparison>().rule(), description_of<PlanRecord>().rule(),
          description_of<ControlDocument>().rule()}) {
        documents.push_back(rule.json());
        definitions.update(rule.definitions());
    }
    const ResultJson schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                            {"title", "Result"},
                            {"description",
                             "A saved result of taut, version 2. All numbers are in SI units. "
                             "Other keys than these may "
                             "occur."},
                            {"oneOf", documents},
                            {"definitions", definitions}};
    return schema.dump(2) + "\n";
}

}  // namespace

const std::string& result_schema() {
    static const std::string schema = schema_of_documents();
    return schema;
}

}  // namespace taut
