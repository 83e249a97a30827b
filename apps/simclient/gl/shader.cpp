#include "simclient/gl/shader.hpp"

#include <string>

namespace physim::client {
namespace {

Result<GLuint> compile(const char* name, GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != 0) return shader;
  char log[1024] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  return Error{std::string("a shader does not compile: ") + log, name, "OpenGL 3.3 is needed"};
}

}  // namespace

Result<Shader> Shader::make(const char* name, const char* vertex, const char* fragment) {
  const Result<GLuint> v = compile(name, GL_VERTEX_SHADER, vertex);
  if (!v) return v.error();
  const Result<GLuint> f = compile(name, GL_FRAGMENT_SHADER, fragment);
  if (!f) return f.error();
  Shader shader;
  shader.program_ = glCreateProgram();
  glAttachShader(shader.program_, *v);
  glAttachShader(shader.program_, *f);
  glLinkProgram(shader.program_);
  glDeleteShader(*v);
  glDeleteShader(*f);
  GLint good = 0;
  glGetProgramiv(shader.program_, GL_LINK_STATUS, &good);
  if (good != 0) return shader;
  char log[1024] = "";
  glGetProgramInfoLog(shader.program_, sizeof log, nullptr, log);
  return Error{std::string("a shader does not link: ") + log, name, "OpenGL 3.3 is needed"};
}

}  // namespace physim::client
