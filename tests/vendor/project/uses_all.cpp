// Something of each collected package, so that its headers are read and its libraries linked.
#include <CLI/Version.hpp>
#include <GL/glew.h>
#include <GLFW/glfw3.h>
#include <ImfHeader.h>
#include <boost/context/detail/fcontext.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <nlohmann/json_fwd.hpp>
#include <spng.h>
#include <sqlite3.h>
#include <stb/stb_image.h>
#include <turbojpeg.h>

int main() {
    const Imf::Header header(2, 3);
    const glm::vec2 v(1, 2);
    const bool works = header.dataWindow().max.y == 2 && fmt::format("{}", glm::dot(v, v)) == "5" &&
                       tjGetErrorStr() != nullptr && spng_version_string() != nullptr &&
                       glewGetErrorString(GLEW_NO_ERROR) != nullptr &&
                       glfwGetVersionString() != nullptr && sqlite3_libversion_number() != 0 &&
                       stbi_failure_reason() == nullptr &&
                       boost::math::cdf(boost::math::students_t(3), 0.0) == 0.5 &&
                       boost::context::detail::make_fcontext != nullptr && testing::Matches(5)(5);
    return works ? 0 : 1;
}
