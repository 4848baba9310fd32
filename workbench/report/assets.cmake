# Everything report.html is made of, put into the program: its page, its charts, the thesis's tables.
set(web ${CMAKE_CURRENT_LIST_DIR}/web)
set(modules ${web}/node_modules)
if(NOT EXISTS ${modules}/vega-embed/build/vega-embed.min.js)
  message(FATAL_ERROR "workbench/report/web/node_modules is missing: run tools/setup")
endif()

coppice_embed(coppice_workbench coppice_report_page_html ${web}/page.html)
coppice_embed(coppice_workbench coppice_report_page_css ${web}/page.css)
coppice_embed(coppice_workbench coppice_report_page_js ${web}/page.js)
coppice_embed(coppice_workbench coppice_report_thesis_csv ${CMAKE_CURRENT_LIST_DIR}/data/thesis_tables.csv)

coppice_embed(coppice_workbench coppice_report_vega ${modules}/vega/build/vega.min.js)
coppice_embed(coppice_workbench coppice_report_vega_lite ${modules}/vega-lite/build/vega-lite.min.js)
coppice_embed(coppice_workbench coppice_report_vega_embed ${modules}/vega-embed/build/vega-embed.min.js)
coppice_embed(coppice_workbench coppice_report_vega_license ${modules}/vega/LICENSE)
coppice_embed(coppice_workbench coppice_report_vega_lite_license ${modules}/vega-lite/LICENSE)
coppice_embed(coppice_workbench coppice_report_vega_embed_license ${modules}/vega-embed/LICENSE)
coppice_embed(coppice_workbench coppice_report_d3_license ${modules}/d3-array/LICENSE)
