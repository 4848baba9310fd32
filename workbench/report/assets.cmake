# Everything report.html is made of, put into the program: its page, its charts, the thesis's tables.
set(web ${CMAKE_CURRENT_LIST_DIR}/web)
set(modules ${web}/node_modules)
if(NOT EXISTS ${modules}/.bin/esbuild)
  message(FATAL_ERROR "workbench/report/web/node_modules is missing or old: run tools/setup")
endif()

# report_script(<name>): web/<name>/main.js with all that it imports, as one script for browsers.
file(GLOB_RECURSE scripts CONFIGURE_DEPENDS ${web}/page/*.js ${web}/inspector/*.js)
function(report_script name)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/report_${name}.js)
  add_custom_command(OUTPUT ${script}
    COMMAND ${modules}/.bin/esbuild ${web}/${name}/main.js --outfile=${script} --log-level=warning
            --bundle --minify --format=iife --target=es2020 --charset=utf8 --legal-comments=none
    DEPENDS ${scripts} ${web}/package-lock.json
    COMMENT "Bundling the report's script ${name}"
    VERBATIM)
  coppice_embed(coppice_workbench coppice_report_${name}_js ${script})
endfunction()
report_script(page)
report_script(inspector)

coppice_embed(coppice_workbench coppice_report_page_html ${web}/page.html)
coppice_embed(coppice_workbench coppice_report_page_css ${web}/page.css)
coppice_embed(coppice_workbench coppice_report_thesis_csv ${CMAKE_CURRENT_LIST_DIR}/data/thesis_tables.csv)

coppice_embed(coppice_workbench coppice_report_vega ${modules}/vega/build/vega.min.js)
coppice_embed(coppice_workbench coppice_report_vega_lite ${modules}/vega-lite/build/vega-lite.min.js)
coppice_embed(coppice_workbench coppice_report_vega_embed ${modules}/vega-embed/build/vega-embed.min.js)
coppice_embed(coppice_workbench coppice_report_vega_license ${modules}/vega/LICENSE)
coppice_embed(coppice_workbench coppice_report_vega_lite_license ${modules}/vega-lite/LICENSE)
coppice_embed(coppice_workbench coppice_report_vega_embed_license ${modules}/vega-embed/LICENSE)
coppice_embed(coppice_workbench coppice_report_d3_license ${modules}/d3-array/LICENSE)
coppice_embed(coppice_workbench coppice_report_three_license ${modules}/three/LICENSE)
