// What platforms' documents say of the files that they read: keys, types, limits. Autumn 2026.
#pragma once

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace raylab {

// The keys of an object and the types of their values, as "key:type".
inline std::set<std::string> keys(const nlohmann::json& object) {
    std::set<std::string> found;
    for (const auto& [key, value] : object.items()) found.insert(key + ":" + value.type_name());
    return found;
}

// A file of Gradescope, of at least one task, with all keys of raylab and no others.
inline nlohmann::json expect_gradescope(const std::string& text) {
    nlohmann::json file = nlohmann::json::parse(text, nullptr, false);
    EXPECT_FALSE(file.is_discarded()) << text;
    if (file.is_discarded()) return file;
    EXPECT_EQ(keys(file), (std::set<std::string>{"score:number", "execution_time:number",
                                                 "output:string", "output_format:string",
                                                 "visibility:string", "stdout_visibility:string",
                                                 "extra_data:object", "tests:array"}));
    EXPECT_FALSE(file["tests"].empty());
    for (const nlohmann::json& test : file["tests"]) {
        EXPECT_EQ(keys(test),
                  (std::set<std::string>{"number:string", "name:string", "score:number",
                                         "max_score:number", "status:string", "output:string",
                                         "output_format:string", "visibility:string"}));
        // A hidden test would hide the total.
        EXPECT_EQ(test["visibility"], "visible");
    }
    return file;
}

// A file of PrairieLearn, at most a megabyte. One that is not gradable says why.
inline nlohmann::json expect_prairielearn(const std::string& text) {
    EXPECT_LT(text.size(), 1000000u);
    nlohmann::json file = nlohmann::json::parse(text, nullptr, false);
    EXPECT_FALSE(file.is_discarded()) << text;
    if (file.is_discarded()) return file;
    std::set<std::string> expected = {"gradable:boolean", "score:number", "message:string",
                                      "output:string", "tests:array"};
    if (file["gradable"] == false) expected.insert("format_errors:array");
    EXPECT_EQ(keys(file), expected);
    EXPECT_GE(file["score"], 0);
    EXPECT_LE(file["score"], 1);
    for (const nlohmann::json& test : file["tests"])
        EXPECT_EQ(keys(test),
                  (std::set<std::string>{"name:string", "points:number", "max_points:number",
                                         "message:string", "output:string"}));
    return file;
}

// A file of Classroom 50, whose points are whole numbers.
inline nlohmann::json expect_classroom50(const std::string& text) {
    nlohmann::json file = nlohmann::json::parse(text, nullptr, false);
    EXPECT_FALSE(file.is_discarded()) << text;
    if (file.is_discarded()) return file;
    EXPECT_EQ(keys(file),
              (std::set<std::string>{"schema:string", "classroom:string", "assignment:string",
                                     "submission:string", "commit:string", "release:string",
                                     "review:string", "datetime:string", "score:number",
                                     "max-score:number", "tests:array"}));
    EXPECT_EQ(file["schema"], "classroom50/result/v1");
    EXPECT_TRUE(file["score"].is_number_integer() && file["max-score"].is_number_integer());
    for (const nlohmann::json& test : file["tests"])
        EXPECT_EQ(keys(test), (std::set<std::string>{"test-name:string", "passed:boolean",
                                                     "score:number", "max-score:number"}));
    return file;
}

} // namespace raylab
