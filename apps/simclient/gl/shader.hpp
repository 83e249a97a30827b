// A linked shader program.
#pragma once

#include <epoxy/gl.h>

#include "physim/result.hpp"

namespace physim::client {

class Shader {
 public:
  Shader() = default;
  [[nodiscard]] static Result<Shader> make(const char* name, const char* vertex, const char* fragment);
  Shader(Shader&& other) noexcept : program_(other.program_) { other.program_ = 0; }
  Shader& operator=(Shader&& other) noexcept {
    std::swap(program_, other.program_);
    return *this;
  }
  ~Shader() {
    if (program_ != 0) glDeleteProgram(program_);
  }

  void use() const { glUseProgram(program_); }
  [[nodiscard]] GLint uniform(const char* name) const { return glGetUniformLocation(program_, name); }

 private:
  GLuint program_ = 0;
};

}  // namespace physim::client
